// One question to the simulator that has a known answer: does the contact stick just below v*, and
// slide just above?
#pragma once

#include <string>

#include "problem/problem.hpp"

namespace vcrit::validation::accuracy {

struct SimulatedCell {
  double threshold = 0;  ///< critical speed of the contact point, m/s; NaN: none found
  std::string wrong;     ///< "misses the stick below v*", ...; empty where both answers are right
};

/// `right`: v* in m/s; where it is no speed nothing is asked.
SimulatedCell simulated_cell(const Problem& problem, double right);

/// Only the threshold, where the motion below it takes too long.
SimulatedCell not_asked(const Problem& problem);

}  // namespace vcrit::validation::accuracy
