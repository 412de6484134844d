// The steady stick-slip motion of a system, found by event-driven motion in closed form.
#pragma once

#include "simulation/system/steady_state.hpp"
#include "simulation/system/system.hpp"

namespace vcrit::simulation {

/// velocity: mean velocity of the drive, m/s, > 0. Throws ModelError where no steady state is
/// found.
SteadyState steady_state(const System& system, double velocity, Start start = Start::sliding,
                         int samples = 0);

/// The lowest speed at which steady pure sliding exists, from the minimum of the contact velocity.
struct SlidingThreshold {
  double contact_velocity = 0;  ///< mean velocity of the contact point there: the simulated v*, m/s
  double drive_velocity = 0;    ///< of the drive; larger only where a network on the path creeps
};
SlidingThreshold sliding_threshold(const System& system);

}  // namespace vcrit::simulation
