#include "simulation/steady/normal_force.hpp"

#include <algorithm>

#include "base/constants.hpp"
#include "simulation/motion/opening.hpp"

namespace vcrit::simulation {

double mean_normal_force(const System& system) {
  if (!system.opening) return system.mean_normal_force;
  return steady_normal_force(*system.opening, system.omega).mean;
}

bool touches_at(const System& system, double phase) {
  if (!system.opening) return true;
  const NormalCycle cycle = steady_normal_force(*system.opening, system.omega);
  return std::any_of(cycle.touches.begin(), cycle.touches.end(),
                     [&](const NormalCycle::Touch& touch) {
                       const double since = phase - touch.begin;
                       return (since < 0 ? since + two_pi : since) <= touch.duration;
                     });
}

}  // namespace vcrit::simulation
