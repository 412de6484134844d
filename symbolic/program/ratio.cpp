#include "program/ratio.hpp"

#include <cmath>

#include "formula/symbols.hpp"

namespace vcrit::symbolic {

namespace {

Ratio of_number(Program& program, double number, bool poisson) {
  // What the program's other commands compute with: the double that was read.
  const GiNaC::numeric given = exact_binary(number);
  const GiNaC::numeric ratio = poisson ? 2 * (1 - given) / (2 - given) : given;
  const double exponent = std::log2(ratio.to_double());
  // As 1/q: one product fewer.
  return {program.constant(1),
          program.constant(1 / ratio),
          1,
          {exponent - 1, exponent + 1},
          {},
          {-exponent - 1, -exponent + 1}};
}

Ratio of_poisson(Program& program, StiffnessWriter& stiffness, NodeId given) {
  const NodeId two = program.constant(2);
  const NodeId one_less = program.subtract(program.constant(1), given);
  const NodeId q = program.subtract(two, given);
  const ExponentRange range = stiffness.guarded(program.size(one_less));
  stiffness.guarded(program.size(q));
  return {program.multiply(two, one_less), q,    2, range - range + ExponentRange{-1, 2},
          range + ExponentRange{1, 1},     range};
}

}  // namespace

Ratio contact_ratio(Program& program, StiffnessWriter& stiffness, const Isotropic& isotropic,
                    const SymbolValue& value) {
  const bool poisson = isotropic.by == Isotropic::By::poisson;
  if (isotropic.quantity.value) return of_number(program, *isotropic.quantity.value, poisson);
  const NodeId given = value(program, isotropic.quantity.symbol);
  if (poisson) return of_poisson(program, stiffness, given);
  const ExponentRange range = stiffness.guarded(program.size(given));
  return {given, program.constant(1), 0, range, range, {}};
}

}  // namespace vcrit::symbolic
