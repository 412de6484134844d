#include "paper/motions.hpp"

#include <cmath>

#include "simulation/methods/methods.hpp"
#include "simulation/steady/exact.hpp"

namespace vcrit::validation::paper {

simulation::System kelvin_contact(double delta, double a) {
  simulation::System system;
  system.contact = {1, delta, {}};
  system.omega = 1;
  system.friction = 1;
  system.mean_normal_force = 1;
  system.normal_force_amplitude = a;
  return system;
}

double critical_velocity(double delta, double a) { return a / std::hypot(1, delta); }

simulation::SteadyState full_motion(double delta, double a, double ratio) {
  return simulation::steady_state(kelvin_contact(delta, a), ratio * critical_velocity(delta, a));
}

double full_friction(double delta, double a, double ratio) {
  return full_motion(delta, a, ratio).friction_ratio;
}

double reduced_friction(double delta, double a, double ratio) {
  const double velocity = ratio * critical_velocity(delta, a);
  return steady_state(simulation::Method::reduced, kelvin_contact(delta, a), velocity)
      .friction_ratio;
}

}  // namespace vcrit::validation::paper
