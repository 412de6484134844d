#include "paper/motions.hpp"

#include <cmath>

#include "simulation/methods/methods.hpp"
#include "simulation/steady/exact.hpp"

namespace vcrit::validation::paper {

double kelvin_critical_velocity(double delta, double a) { return a / std::hypot(1, delta); }

simulation::SteadyState full_motion(double delta, double a, double ratio) {
  return simulation::steady_state(kelvin_contact(delta, a),
                                  ratio * kelvin_critical_velocity(delta, a));
}

double full_friction(double delta, double a, double ratio) {
  return full_motion(delta, a, ratio).friction_ratio;
}

double reduced_friction(double delta, double a, double ratio) {
  const double velocity = ratio * kelvin_critical_velocity(delta, a);
  return steady_state(simulation::Method::reduced, kelvin_contact(delta, a), velocity)
      .friction_ratio;
}

}  // namespace vcrit::validation::paper
