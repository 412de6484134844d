// Time and error of all evaluators of a problem, taken in turns.
#pragma once

#include <string>
#include <vector>

#include "speed/methods.hpp"

namespace vcrit::speed {

struct Plan {
  std::size_t values = 1024;  ///< in an array
  double seconds = 2;         ///< for all methods on one problem in one mode
};

struct Result {
  std::string subject, method;
  CallMode mode = CallMode::sweep;
  MethodFamily family = MethodFamily::peer;
  double nanoseconds = 0;  ///< a value
  double error = 0;        ///< the worst, in units of the last place; 0 for the machine's limits
  bool wrong() const;      ///< relative error above 1e-10
};

/// Evaluators of other modes are left out.
std::vector<Result> measure(const Subject& subject, CallMode mode,
                            const std::vector<TimedMethod>& all, const Plan& plan);

}  // namespace vcrit::speed
