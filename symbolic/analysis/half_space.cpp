#include "analysis/half_space.hpp"

#include "base/errors.hpp"
#include "derivation/model.hpp"
#include "formula/algebra_lock.hpp"
#include "formula/symbols.hpp"

namespace vcrit::symbolic {

using GiNaC::ex;

std::vector<Line> half_space_lines(const Derivation& derivation) {
  const AlgebraLock lock;
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
  return {{"Each width b of the contact is a contact of its own, with E* b, E* = E/(1 - nu^2)",
           quantity("K_n"), normal},
          {"and along the surface with G* b, G* = 4 G/(2 - nu), G = E/(2(1 + nu))", quantity("K_t"),
           tangential},
          {"Their ratio is the same everywhere, whatever E is made of and the shape is",
           quantity("K_t") / quantity("K_n"), ratio},
          {"so that all have one v*", quantity("v*"), derivation.critical_velocity}};
}

}  // namespace vcrit::symbolic
