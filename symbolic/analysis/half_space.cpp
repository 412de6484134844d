#include "analysis/half_space.hpp"

#include "base/errors.hpp"
#include "derivation/model.hpp"
#include "formula/algebra_lock.hpp"
#include "formula/symbols.hpp"

namespace vcrit::symbolic {

using GiNaC::ex;

std::vector<Line> half_space_lines(const Derivation& derivation) {
  const AlgebraLock lock;
  if (!derivation.problem->indenter)
    throw InputError(argument("derivation"), "a scene without an indenter", "one with [indenter]");
  const auto& isotropic = std::get<Isotropic>(derivation.problem->tangential);
  const auto& given = isotropic.quantity.value;
  const ex nu = given ? ex(exact_decimal(*given)) : poisson_ratio(isotropic.quantity.symbol);
  const ex E = quantity("E"), b = quantity("b");
  const ex normal = E / (1 - nu * nu) * b;
  const ex shear = E / (2 * (1 + nu));
  const ex tangential = 4 * shear / (2 - nu) * b;
  const ex ratio = (tangential / normal).normal();
  ensure((ratio - isotropic_ratio(isotropic)).normal().is_zero(),
         "below an indenter K_t/K_n is that of an isotropic contact");
  const ex own_nu = given ? quantity("nu") : nu;
  const ex plane = quantity("E_r"), shearing = quantity("G_r"), G = quantity("G");
  return {
      {{"Each width ", b, " of the contact is a contact of its own, with ", plane * b, ", ",
        stated(plane, E / (1 - own_nu * own_nu))},
       quantity("K_n"),
       normal},
      {{"and along the surface with ", shearing * b, ", ", stated(shearing, 4 * G / (2 - own_nu)),
        ", ", stated(G, E / (2 * (1 + own_nu)))},
       quantity("K_t"),
       tangential},
      {{"Their ratio is the same everywhere, whatever ", E, " is made of and the shape is"},
       quantity("K_t") / quantity("K_n"),
       ratio},
      {{"so that all have one ", quantity("v*")}, quantity("v*"), derivation.critical_velocity}};
}

}  // namespace vcrit::symbolic
