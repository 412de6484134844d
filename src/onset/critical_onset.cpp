#include "onset/critical_onset.hpp"

#include <cmath>
#include <limits>

#include "base/constants.hpp"
#include "critical/admissibility.hpp"
#include "critical/certified.hpp"
#include "indenter/friction.hpp"
#include "simulation/steady/normal_force.hpp"
#include "simulation/steady/onset.hpp"

namespace vcrit {

namespace {

bool elastic(const Network& network) {
  bool only_springs = true;
  for_each_element(network, [&](const Element& element) {
    only_springs = only_springs && element.kind == ElementKind::spring;
  });
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

CriticalOnset by_formula(const Scene& scene) {
  const auto [value, bound, reason] = certified_critical_velocity(scene);
  return {CriticalOnset::By::formula, value, value + creep_velocity(scene), bound, reason};
}

CriticalOnset by_simulation(const simulation::Onset& onset) {
  return {CriticalOnset::By::simulation, onset.contact_velocity, onset.drive_velocity,
          std::numeric_limits<double>::quiet_NaN(), onset.why_infinite};
}

// All cells have the same v* while they are closed, and none has more; the centre parts last.
CriticalOnset of_indenter(const Scene& scene) {
  const indenter::HalfSpace half_space(scene);
  if (simulation::touches_at(half_space.cell(0), steepest_phase)) return by_formula(scene);
  return by_simulation(indenter::critical_velocity(half_space));
}

}  // namespace

CriticalOnset critical_onset(const Scene& scene) {
  if (!scene.separation || !opens(scene)) return by_formula(scene);
  if (elastic(scene)) return by_formula(scene);
  if (scene.indenter) return of_indenter(scene);
  const simulation::System system = simulation::system_of(scene);
  if (isotropic(scene) && simulation::touches_at(system, steepest_phase)) return by_formula(scene);
  return by_simulation(simulation::sliding_threshold(system));
}

}  // namespace vcrit
