// Where a cycle sticks or slips backward.
#pragma once

#include <vector>

#include "simulation/system/steady_state.hpp"

namespace vcrit::validation::report {

/// A stretch of one period in which the contact does not slip forward; times in the given unit.
struct MotionStretch {
  double from = 0, to = 0;
  bool backward = false;  ///< slips backward; else sticks
};
std::vector<MotionStretch> stretches(const std::vector<simulation::CyclePoint>& cycle,
                                     double per_phase);

}  // namespace vcrit::validation::report
