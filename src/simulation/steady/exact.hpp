// The steady stick-slip motion of a system, found by event-driven motion in closed form.
#pragma once

#include "simulation/system/steady_state.hpp"
#include "simulation/system/system.hpp"

namespace vcrit::simulation {

/// velocity: mean velocity of the drive, m/s, > 0. Throws ModelError where no steady state is
/// found, InputError for a speed that is not above 0 and for fewer samples than none.
SteadyState steady_state(const System& system, double velocity, Start start = Start::sliding,
                         int samples = 0);

}  // namespace vcrit::simulation
