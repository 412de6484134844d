// Sliding without stick of a contact that opens. Its force is the bound whatever the speed of the
// drive, and so is its motion but for that speed: the lowest contact velocity tells from which
// speed on it never stops.
#pragma once

#include "simulation/motion/model.hpp"

namespace vcrit::simulation {

/// The least velocity of the drive, without dimension, at which a contact that opens slips forward
/// whenever it touches; infinite where it sticks for a moment each time the surfaces meet, however
/// fast the drive: with a normal force that jumps, and a tangential one that cannot.
double forward_sliding_threshold(const Model& model);

}  // namespace vcrit::simulation
