// Why no motion is found: sizes that lie further apart than doubles have digits.
#pragma once

#include "base/errors.hpp"
#include "simulation/motion/model.hpp"

namespace vcrit::simulation {

/// Throws `last`, what a search for a motion ended with. Where contact, drive and body are so far
/// apart that their sums lose one of them, ModelError names the smallest and the largest of them
/// instead: whatever else the search stumbled over came from it.
[[noreturn]] void no_motion_found(const Model& model, const ModelError& last);

/// The same of a motion of a velocity, and where the drive hardly moves in a period, that.
[[noreturn]] void no_motion_found(const Model& model, double velocity, const ModelError& last);

}  // namespace vcrit::simulation
