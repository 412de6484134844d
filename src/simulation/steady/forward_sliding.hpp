// Sliding without stick of a contact that opens. Its force is the bound whatever the speed of the
// drive, and so is its motion but for that speed: the lowest contact velocity tells from which
// speed on it never stops.
#pragma once

#include "simulation/motion/model.hpp"

namespace vcrit::simulation {

struct ForwardSliding {
  enum class Ends {
    at_a_speed,
    sticks_at_closings,  ///< the normal force jumps and the tangential one cannot: at any speed
    in_resonance,        ///< an undamped drive at a harmonic of the normal force: grows for ever
  };
  Ends ends = Ends::at_a_speed;
  /// The least velocity of the drive, without dimension, at which the contact slips forward
  /// whenever it is closed; infinite where none is enough.
  double least_velocity = 0;
  double error = 0;  ///< of it, estimated
};

/// Throws ModelError where the motion is lost in rounding.
ForwardSliding forward_sliding(const Model& model);

}  // namespace vcrit::simulation
