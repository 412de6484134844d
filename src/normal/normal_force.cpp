#include "normal/normal_force.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/constants.hpp"
#include "modes/endless_times.hpp"

namespace vcrit::simulation {

namespace {

Relaxation in_radians(Relaxation form, double omega) {
  form.damper *= omega;
  for (MaxwellBranch& branch : form.branches) branch.time *= omega;
  return form;
}

}  // namespace

double wrapped(double t) {
  const double result = t - two_pi * std::floor(t / two_pi);
  return result < two_pi ? result : 0;
}

bool answers_at_once(const NormalMotion& motion, double omega) {
  const Relaxation given = in_radians(motion.network, omega);
  const Relaxation moving = normal_without_shortest_times(given);
  return (moving.damper == 0 && given.damper > 0) ||
         std::any_of(given.branches.begin(), given.branches.end(), relaxes_at_once);
}

ContactModes modes_of(const NormalMotion& motion, double omega) {
  return contact_modes(normal_without_shortest_times(in_radians(motion.network, omega)));
}

NormalCycle steady_normal_force(const NormalMotion& motion, double omega) {
  return normal_cycle(modes_of(motion, omega), {motion.mean, motion.amplitude});
}

bool touches_at(const NormalMotion& motion, double omega, double phase) {
  const NormalCycle cycle = steady_normal_force(motion, omega);
  return std::any_of(cycle.touches.begin(), cycle.touches.end(),
                     [&](const NormalCycle::Touch& touch) {
                       const double since = phase - touch.begin;
                       return (since < 0 ? since + two_pi : since) <= touch.duration;
                     });
}

}  // namespace vcrit::simulation
