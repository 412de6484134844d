#include "speed/measurement.hpp"

#include <algorithm>
#include <chrono>

#include "base/constants.hpp"

namespace vcrit::speed {

namespace {

using Clock = std::chrono::steady_clock;

// Long against the clock's own time, short against the scheduler's slices.
constexpr double shortest = 20e-6;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

class Timed {
 public:
  explicit Timed(std::function<void()> run) : run_(std::move(run)) {
    run_();
    while (once() < shortest) repeats_ *= 2;
  }
  void again() {
    run_();  // with its own data in cache, not what the one before left there
    best_ = std::min(best_, once() / repeats_);
  }
  double best() const { return best_; }

 private:
  double once() const {
    const Clock::time_point start = Clock::now();
    for (int i = 0; i < repeats_; ++i) run_();
    return seconds_since(start);
  }
  std::function<void()> run_;
  int repeats_ = 1;
  double best_ = infinity;
};

/// One after the other, again and again: a slow phase of the machine hits all alike.
void take_turns(std::vector<Timed>& all, double seconds) {
  const Clock::time_point start = Clock::now();
  do
    for (Timed& each : all) each.again();
  while (seconds_since(start) < seconds);
}

}  // namespace

bool Result::wrong() const { return !(error < 1e-10 / 0x1p-52); }

std::vector<Result> measure(const Subject& subject, CallMode mode,
                            const std::vector<TimedMethod>& all, const Plan& plan) {
  const Samples samples(subject, mode, plan.values);
  const std::vector<double> exact = reference(subject, samples);
  std::vector<double> out(plan.values), extra(plan.values * (subject.columns.size() + 1));
  std::vector<Result> results;
  std::vector<Timed> times;
  for (const TimedMethod& each : all) {
    if (each.mode != mode) continue;
    each.prepare(samples);
    out.assign(out.size(), 0);
    times.emplace_back([&] { each.run(samples, out.data(), extra.data()); });
    const double error = each.family == MethodFamily::machine ? 0 : worst_error(out, exact);
    results.push_back({subject.name, each.method, mode, each.family, 0, error});
  }
  take_turns(times, plan.seconds);
  for (std::size_t i = 0; i < results.size(); ++i)
    results[i].nanoseconds = 1e9 * times[i].best() / static_cast<double>(plan.values);
  return results;
}

}  // namespace vcrit::speed
