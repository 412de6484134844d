// The stretches of frequency in which friction can be reduced at a speed at all: where the drive
// velocity limit, v* and the creep, lies above it. Outside, sliding is steady and friction is full.
#pragma once

#include <vector>

#include "problem/problem.hpp"

namespace vcrit::design {

struct Stretch {
  double from = 0, to = 0;  ///< rad/s
};

struct Stretches {
  std::vector<Stretch> parts;   ///< rising
  double largest_velocity = 0;  ///< the largest limit that was met, m/s; may be infinite
  double largest_at = 0;        ///< where, rad/s
};

/// Between two angular frequencies (rad/s, from < to) at a drive velocity (m/s), from some thousand
/// values of Eq. 24 and a search of each of their peaks.
Stretches reducing_stretches(const Problem& problem, double from, double to, double velocity);

}  // namespace vcrit::design
