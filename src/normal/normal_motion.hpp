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

/// A contact that opens by less than this share of the mean force is taken for closed. Of one
/// contact that is rounding: it opens at one instant of the period. A cell below an indenter would
/// be open for some 1e-4 of it, and where a strongly damped contact hardly opens no steady force
/// is found.
constexpr double least_separation(bool below_indenter) { return below_indenter ? 1e-8 : 1e-14; }

}  // namespace vcrit::simulation
