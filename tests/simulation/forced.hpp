// Systems under a given normal force, at omega = 1.
#pragma once

#include <complex>

#include "simulation/system/system.hpp"

namespace vcrit::reference {

/// A contact under a rigid drive; `normal_force`: N, what it oscillates by about its mean.
inline simulation::System forced(const Relaxation& contact, double mean_normal_force,
                                 std::complex<double> normal_force, double friction = 0.5) {
  simulation::System system;
  system.contact = contact;
  system.omega = 1;
  system.friction = friction;
  system.mean_normal_force = mean_normal_force;
  system.normal_force_amplitude = normal_force;
  return system;
}

/// With a body on a drive.
inline simulation::System forced(const Relaxation& contact, const Relaxation& drive, double mass,
                                 double mean_normal_force, std::complex<double> normal_force,
                                 double friction = 0.5) {
  simulation::System system = forced(contact, mean_normal_force, normal_force, friction);
  system.drive = drive;
  system.mass = mass;
  return system;
}

}  // namespace vcrit::reference
