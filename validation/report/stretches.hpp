// When a cycle sticks or slips backward.
#pragma once

#include <vector>

#include "compare/scene_report.hpp"

namespace vcrit::validation::report {

/// A stretch of one period in which the contact sticks or slips backward; times in the given unit.
struct MotionStretch {
  double from = 0, to = 0;
  bool backward = false;  ///< slips backward; else sticks
};
/// By the times of its events, in their order; one that goes on over the end of the period is two.
std::vector<MotionStretch> stretches(const Cycle& cycle, double per_phase);

}  // namespace vcrit::validation::report
