// The stretches of frequency in which friction can be reduced at a speed at all: where the drive
// velocity limit, v* and the creep, lies above it. Outside, sliding is steady and friction is full.
// Below a mount the amplitude at the contact depends on the frequency, so that the contact stays
// closed in stretches, too.
#pragma once

#include <functional>
#include <vector>

#include "problem/problem.hpp"

namespace vcrit::design {

struct FrequencyRange {
  double from = 0, to = 0;  ///< rad/s
};

struct Stretches {
  std::vector<FrequencyRange> parts;  ///< rising
  double largest_velocity = 0;        ///< the largest limit that was met, m/s; may be infinite
  double largest_at = 0;              ///< where, rad/s
  bool closed = true;                 ///< whether the contact was met closed anywhere
};

/// The share of the largest amplitude at an angular frequency (rad/s): below 1 the contact is
/// closed.
using OpeningShare = std::function<double(double)>;

/// Between two angular frequencies (rad/s, from < to) at a drive velocity (m/s), from some thousand
/// values of Eq. 24 and a search of each of their peaks; with `share`, of those where the contact
/// stays closed. The largest limit is that of places where it does.
Stretches reducing_stretches(const Problem& problem, double from, double to, double velocity,
                             const OpeningShare& share = {});

}  // namespace vcrit::design
