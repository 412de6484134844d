// Work in a process of its own, ended when its time or memory is used up: whatever a method does,
// the benchmark goes on. What is timed is timed inside that process, so no start of a process
// counts.
#pragma once

#include <array>
#include <chrono>
#include <functional>
#include <string>

namespace vcrit::bench {

/// What goes through the pipe.
using ChildNumbers = std::array<double, 3>;

enum class Ending {
  answered,
  refused,  ///< the work threw: `words` says why
  out_of_time,
  crashed,
};

struct Report {
  Ending ending = Ending::crashed;
  ChildNumbers numbers = {};
  std::string words = {};
};

/// 12 GiB of addresses: expanded forms may grow without end.
inline constexpr std::size_t most_memory = std::size_t{12} << 30;

struct Limits {
  std::chrono::duration<double> time;  ///< processor time
  /// Programs that the work starts have the same time each, in whole seconds, and all
  /// `most_memory`.
  bool of_programs = false;
};

/// The process keeps the memory that the work gives back: taking it from the system again would
/// count as the method's time, or not, depending on what was measured before.
Report in_child(const Limits& limits, const std::function<ChildNumbers()>& work);

/// For the work: the rest of it may take any time.
void lift_time_limit();

}  // namespace vcrit::bench
