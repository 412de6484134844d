#include "harness/timing.hpp"

#include <algorithm>
#include <ctime>
#include <vector>

namespace vcrit::bench {

namespace {

// The first run in a process pays for the pages that it shares with its parent, and for functions
// of libraries that are looked up when they are called first: up to half a millisecond. Twenty
// times that is long enough.
constexpr double long_enough = 10e-3;
// A thousand times what reading the clock takes.
constexpr double shortest_batch = 2e-4;

double time_of(const std::function<void()>& run, int times) {
  const double begin = processor_time();
  for (int i = 0; i < times; ++i) run();
  return (processor_time() - begin) / times;
}

}  // namespace

double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double settled_time(const std::function<void()>& run, double first, double repeat) {
  if (first > long_enough) return first;
  const double second = time_of(run, 1);
  const int batch = static_cast<int>(std::clamp(shortest_batch / second, 1.0, 1000.0));
  const int count = static_cast<int>(std::clamp(repeat / (batch * second), 5.0, 51.0));
  std::vector<double> times;
  for (int i = 0; i < count; ++i) times.push_back(time_of(run, batch));
  std::nth_element(times.begin(), times.begin() + count / 2, times.end());
  return times[static_cast<std::size_t>(count / 2)];
}

double settled_time(const std::function<void()>& run, double repeat) {
  return settled_time(run, time_of(run, 1), repeat);
}

}  // namespace vcrit::bench
