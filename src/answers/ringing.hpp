// How a body oscillates on contact and drive while the contact sticks.
#pragma once

#include "simulation/system/system.hpp"

namespace vcrit {

/// The largest dynamic amplification of a body whose contact sticks: its displacement under a force
/// at a harmonic of the oscillation over that under a constant force. 1 without a body, infinite in
/// an undamped resonance.
double ringing(const simulation::System& system);

}  // namespace vcrit
