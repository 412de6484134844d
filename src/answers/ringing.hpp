// A body that sticks and swings on contact and drive.
#pragma once

#include "simulation/system/system.hpp"

namespace vcrit {

/// How many times its way at rest a body swings that sticks and is pushed at a harmonic of the
/// oscillation: 1 without a body, infinite in an undamped resonance.
double ringing(const simulation::System& system);

}  // namespace vcrit
