#include "simulation/steady/normal_force.hpp"

#include "normal/normal_force.hpp"
#include "simulation/system/check.hpp"

namespace vcrit::simulation {

double mean_normal_force(const System& system) {
  check_system(system);
  if (!system.opening) return system.mean_normal_force;
  return steady_normal_force(*system.opening, system.omega).mean;
}

}  // namespace vcrit::simulation
