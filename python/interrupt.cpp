#include "interrupt.hpp"

#include <chrono>

namespace vcrit::python {

namespace {

using Clock = std::chrono::steady_clock;

// Python's signal handlers run in its main thread alone, and there when it is asked to. Often
// enough that nobody waits, seldom enough that other threads keep the interpreter.
void hear_signals() {
  constexpr auto between = std::chrono::milliseconds(50);
  thread_local Clock::time_point last = Clock::now();
  const Clock::time_point now = Clock::now();
  if (now - last < between) return;
  last = now;
  const pybind11::gil_scoped_acquire python;
  if (PyErr_CheckSignals() != 0) throw Interrupted{};
}

}  // namespace

OthersRun::OthersRun() : interruptible_(&hear_signals) {}

}  // namespace vcrit::python
