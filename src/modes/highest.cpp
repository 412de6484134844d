#include "modes/highest.hpp"

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"
#include "base/errors.hpp"

namespace vcrit::simulation {

namespace {

class Ascent {
 public:
  Ascent(EventFunction& f, double end) : f_(f), end_(end) {
    take(at(0));
    take(at(end));
  }

  double run() {
    EventFunction::Point here = f_.move_to(0);
    for (int i = 0; i < most_steps; ++i) {
      if (here.time >= end_) return highest_;
      const double step = f_.safe_step(here.value - level(), h_);
      if (here.slope * step > 0.5 * (level() - here.value) && climb(here, step)) continue;
      here = f_.move_to(std::min(end_, here.time + std::max(step, least_step(here.time))));
      take(here);
    }
    throw ModelError("too many oscillations between two closings of the contact");
  }

 private:
  // A few for each swing of a touch, of which sensible motions have some thousand at the most.
  static constexpr int most_steps = 1'000'000;

  static double least_step(double t) { return std::max(epsilon * t, 1e-300); }

  EventFunction::Point at(double time) const { return f_.at(ModalFactors(f_.spectrum(), time)); }

  void take(const EventFunction::Point& p) {
    highest_ = std::max(highest_, p.value);
    noise_ = std::max(noise_, p.noise);
  }
  // Nothing counts as higher within rounding.
  double level() const { return highest_ + 2 * noise_; }

  // Follows f uphill to where it turns; whether that is above the level. What lies between is
  // gone through again below the new one.
  bool climb(const EventFunction::Point& from, double step) {
    double low = from.time, high = end_;
    for (step = std::max(step, least_step(low)); low + step < end_; step *= 2) {
      if (at(low + step).slope <= 0) {
        high = low + step;
        break;
      }
      low += step;
    }
    for (int i = 0; i < 100 && high - low > epsilon * high; ++i) {
      const double middle = 0.5 * (low + high);
      (at(middle).slope > 0 ? low : high) = middle;
    }
    const double before = level();
    take(at(high));
    take(at(low));
    return highest_ > before;
  }

  EventFunction& f_;
  double end_;
  double highest_ = -infinity, noise_ = 0;
  double h_ = 1;
};

}  // namespace

double highest(EventFunction& f, double end) { return Ascent(f, end).run(); }

}  // namespace vcrit::simulation
