#include "onset/formula_scope.hpp"

#include "base/constants.hpp"
#include "critical/admissibility.hpp"
#include "indenter/friction.hpp"
#include "network/law.hpp"
#include "normal/normal_force.hpp"

namespace vcrit {

namespace {

bool elastic(const Network& network) {
  bool only_springs = true;
  for_each_element(
      network, [&](const Element& element) { only_springs = only_springs && is_elastic(element); });
  return only_springs;
}

bool elastic(const Scene& scene) {
  return elastic(scene.normal) && elastic(*tangential_network(scene).network) && !scene.mass &&
         !scene.receptance && (!scene.drive || elastic(*scene.drive));
}

bool isotropic(const Scene& scene) {
  return std::holds_alternative<Isotropic>(scene.tangential) && !has_drive(scene);
}

// u_z = u_z0 + du_z cos(omega t) rises fastest there.
constexpr double steepest_phase = 1.5 * pi;

// Below an indenter all cells have the same v* while they are closed, and none has more; the centre
// parts last.
simulation::System last_to_part(const Scene& scene) {
  return scene.indenter ? indenter::HalfSpace(scene).cell(0) : simulation::system_of(scene);
}

}  // namespace

FormulaScope formula_scope(const Scene& scene) {
  if (!scene.separation || elastic(scene)) return FormulaScope::always;
  return scene.indenter || isotropic(scene) ? FormulaScope::while_touching : FormulaScope::never;
}

bool formula_holds(const Scene& scene) {
  const FormulaScope scope = formula_scope(scene);
  if (scope == FormulaScope::always || !opens(scene)) return true;
  if (scope == FormulaScope::never) return false;
  const simulation::System system = last_to_part(scene);
  return !system.opening || simulation::touches_at(*system.opening, system.omega, steepest_phase);
}

}  // namespace vcrit
