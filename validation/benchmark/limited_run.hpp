// One solve in a process of its own, timed there and ended when its time is over: whatever a method
// does, the benchmark goes on.
#pragma once

#include <chrono>
#include <functional>
#include <string>

namespace vcrit::benchmark {

struct Answer {
  double friction_ratio = 0;
  std::size_t events = 0;  ///< of one period
};

enum class Ending {
  answered,
  refused,  ///< the method threw: `words` says why
  out_of_time,
  crashed,
};

struct Run {
  Ending ending = Ending::crashed;
  Answer answer;
  double seconds = 0;  ///< processor time of one solve, the median of several where it is short
  std::string words;
};

/// Both in processor time: the budget is that of the first solve, which is repeated for about
/// `repeat` more if it was short.
Run run_limited(const std::function<Answer()>& solve, std::chrono::duration<double> budget,
                std::chrono::duration<double> repeat);

}  // namespace vcrit::benchmark
