// One period of the steady motion of a scene, to be drawn.
#pragma once

#include "compare/scene_report.hpp"
#include "simulation/system/system.hpp"

namespace vcrit::validation {

/// At a velocity of the drive, m/s; its `ratio` is the caller's to set. Throws ModelError (no
/// steady state).
Cycle steady_cycle(const simulation::System& system, double velocity);

}  // namespace vcrit::validation
