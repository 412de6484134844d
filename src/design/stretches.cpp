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
  double x, excess;  // log(omega), log((v* + creep)/v0) or, if less, log(1/share)
  double limit;      // v* + creep, m/s
  bool closed;
};

// A root finder wants finite numbers, at resonance too; the simulator speaks for itself there.
double finite(double logarithm) { return std::clamp(logarithm, -700.0, 700.0); }

class Looking {
 public:
  Looking(const Problem& problem, double velocity, const OpeningShare& share)
      : problem_(problem), velocity_(velocity), creep_(creep_velocity(problem)), share_(share) {}

  Stretches between(double from, double to) {
    std::vector<Sample> samples;
    for (int i = 0; i <= intervals; ++i) {
      const double part = static_cast<double>(i) / intervals;
      const double omega = i == intervals ? to : from * std::pow(to / from, part);
      samples.push_back(sample(std::log(omega)));
    }
    samples = with_peaks(samples);
    found_.closed = std::ranges::any_of(samples, &Sample::closed);
    for (const Sample& each : samples)
      if (each.closed && each.limit > found_.largest_velocity)
        found_.largest_velocity = each.limit, found_.largest_at = std::exp(each.x);
    collect(samples, {from, to});
    return found_;
  }

 private:
  Sample sample(double x) const {
    const double omega = std::exp(x);
    const double reduces = finite(std::log((quick_onset(problem_, omega) + creep_) / velocity_));
    const double closes = share_ ? finite(-std::log(share_(omega))) : reduces;
    return {x, std::min(reduces, closes), velocity_ * std::exp(reduces), !share_ || closes > 0};
  }
  double excess(double x) const { return sample(x).excess; }

  std::vector<Sample> with_peaks(const std::vector<Sample>& samples) const {
    std::vector<Sample> result;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      result.push_back(samples[i]);
      if (i == 0 || i + 1 == samples.size() || samples[i].excess < samples[i - 1].excess ||
          samples[i].excess < samples[i + 1].excess)
        continue;
      std::uintmax_t steps = 100;
      const double x =
          boost::math::tools::brent_find_minima([&](double at) { return -excess(at); },
                                                samples[i - 1].x, samples[i + 1].x, 40, steps)
              .first;
      if (x < samples[i].x)
        result.insert(result.end() - 1, sample(x));
      else if (x > samples[i].x)
        result.push_back(sample(x));
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
  void collect(const std::vector<Sample>& samples, const FrequencyRange& range) {
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
  OpeningShare share_;
  Stretches found_;
};

}  // namespace

Stretches reducing_stretches(const Problem& problem, double from, double to, double velocity,
                             const OpeningShare& share) {
  return Looking(problem, velocity, share).between(from, to);
}

}  // namespace vcrit::design
