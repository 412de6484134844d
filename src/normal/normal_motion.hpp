// What moves a contact that opens: its normal network below an indentation that oscillates.
#pragma once

#include "stiffness/relaxation.hpp"

namespace vcrit::simulation {

/// The normal network below the indentation mean + amplitude cos(omega t).
struct NormalMotion {
  Relaxation network;    ///< with a spring that carries the static load
  double mean = 0;       ///< m, of any sign
  double amplitude = 0;  ///< m, > 0
};

}  // namespace vcrit::simulation
