#include "design/stretches.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

#include "answers/critical_onset.hpp"
#include "critical/admissibility.hpp"

namespace vcrit::design {

namespace {

// Over four decades neighbours are a quarter of a per cent apart. A narrower peak still shows by
// its flanks, which fall like the distance from it, as long as nothing else is higher there.
constexpr int intervals = 4000;

struct Sample {
  double x, excess;  // log(omega), log((v* + creep)/v0)
};

class Looking {
 public:
  Looking(const Problem& problem, double velocity)
      : problem_(problem), velocity_(velocity), creep_(creep_velocity(problem)) {}

  Stretches between(double from, double to) {
    std::vector<Sample> samples;
    for (int i = 0; i <= intervals; ++i) {
      const double part = static_cast<double>(i) / intervals;
      const double omega = i == intervals ? to : from * std::pow(to / from, part);
      samples.push_back(sample(std::log(omega)));
    }
    samples = with_peaks(samples);
    for (const Sample& each : samples)
      if (velocity_ * std::exp(each.excess) > found_.largest_velocity)
        found_.largest_velocity = velocity_ * std::exp(each.excess),
        found_.largest_at = std::exp(each.x);
    collect(samples, {from, to});
    return found_;
  }

 private:
  double excess(double x) const {
    // A root finder wants finite numbers, at resonance too; the simulator speaks for itself there.
    const double limit = std::log((quick_onset(problem_, std::exp(x)) + creep_) / velocity_);
    return std::clamp(limit, -700.0, 700.0);
  }
  Sample sample(double x) const { return {x, excess(x)}; }

  std::vector<Sample> with_peaks(const std::vector<Sample>& samples) const {
    std::vector<Sample> result;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      result.push_back(samples[i]);
      if (i == 0 || i + 1 == samples.size() || samples[i].excess < samples[i - 1].excess ||
          samples[i].excess < samples[i + 1].excess)
        continue;
      std::uintmax_t steps = 100;
      const auto [x, lowest] = boost::math::tools::brent_find_minima(
          [&](double at) { return -excess(at); }, samples[i - 1].x, samples[i + 1].x, 40, steps);
      if (x < samples[i].x)
        result.insert(result.end() - 1, {x, -lowest});
      else if (x > samples[i].x)
        result.push_back({x, -lowest});
    }
    return result;
  }

  double crossing(const Sample& a, const Sample& b) const {
    std::uintmax_t steps = 100;
    return boost::math::tools::toms748_solve([&](double x) { return excess(x); }, a.x, b.x,
                                             boost::math::tools::eps_tolerance<double>(50), steps)
        .first;
  }

  // exp(log(omega)) is not omega to the last bit, so the ends of the range are taken as they are.
  void collect(const std::vector<Sample>& samples, const Stretch& range) {
    bool inside = false;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const bool reduces = samples[i].excess > 0;
      if (reduces == inside) continue;
      const double edge =
          i == 0 ? range.from
                 : std::clamp(std::exp(crossing(samples[i - 1], samples[i])), range.from, range.to);
      if (reduces)
        found_.parts.push_back({edge, range.to});
      else
        found_.parts.back().to = edge;
      inside = reduces;
    }
  }

  Problem problem_;
  double velocity_, creep_;
  Stretches found_;
};

}  // namespace

Stretches reducing_stretches(const Problem& problem, double from, double to, double velocity) {
  return Looking(problem, velocity).between(from, to);
}

}  // namespace vcrit::design
