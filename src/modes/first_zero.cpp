#include "modes/first_zero.hpp"

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"
#include "base/errors.hpp"

namespace vcrit::simulation {

namespace {

class March {
 public:
  March(EventFunction& f, double end, bool leaving) : f_(f), end_(end), leaving_(leaving) {}

  std::optional<double> run(double from) {
    EventFunction::Point here = f_.move_to(from);
    if (leaving_) here.value = 0;
    for (int i = 0; i < most_steps; ++i) {
      if (here.time >= end_) return std::nullopt;
      const bool at_start = leaving_ && here.time == 0;
      if (!at_start && here.value >= -here.noise) {
        if (here.slope > 0 || (here.curvature > 0 && !falls_away(here))) return polished(here);
        here = f_.move_to(here.time + past(here));
        continue;
      }
      const double step = f_.safe_step(here.value, h_);
      if (step <= least_step(here.time)) {
        if (!at_start) return polished(here);
        return 0.0;
      }
      if (arrived(here, step)) return polished(here);
      here = f_.move_to(std::min(end_, here.time + step));
    }
    throw ModelError("too many oscillations before the next change of stick and slip");
  }

 private:
  // A few for each swing, of which sensible motions have some thousand at the most.
  static constexpr int most_steps = 1'000'000;

  static double least_step(double t) { return t == 0 ? 1e-300 : epsilon * t; }

  // How far f has to fall to be out of the rounding.
  static double above(const EventFunction::Point& p) { return std::max(p.value, 0.0) + p.noise; }

  // f falls out of the rounding before it rises again: with slope -s and curvature c by s^2/(2 c),
  // of which it needs the value and one noise, and has twice as much.
  static bool falls_away(const EventFunction::Point& p) {
    return p.slope < 0 && p.slope * p.slope > 4 * p.curvature * above(p);
  }

  // f is within rounding of zero and turning down: a touch, left behind by twice the time that it
  // takes f to get out of the rounding.
  static double past(const EventFunction::Point& p) {
    const double by_slope = p.slope < 0 ? 2 * above(p) / -p.slope : 1e-8;
    const double by_curvature = p.curvature < 0 ? 2 * std::sqrt(above(p) / -p.curvature) : 1e-8;
    return std::max(std::min(by_slope, by_curvature), 2 * least_step(p.time));
  }

  // So close to a simple zero that slope and curvature carry there without loss.
  static bool within_reach(const EventFunction::Point& p, double step) {
    return std::abs(step) < 1e-6 * std::min(p.time, 1.0) &&
           std::abs(step * p.curvature) < 1e-3 * p.slope;
  }

  // The next safe step goes nearly all the way there.
  static bool arrived(const EventFunction::Point& p, double step) {
    return p.slope * step > -0.9 * p.value && within_reach(p, step);
  }

  double polished(const EventFunction::Point& p) const {
    const double step = -p.value / p.slope;
    if (!within_reach(p, step)) return std::min(end_, p.time);
    return std::min(end_, p.time + step - 0.5 * p.curvature / p.slope * step * step);
  }

  EventFunction& f_;
  double end_;
  bool leaving_;
  double h_ = 1;
};

// Shares of a radian, as those of a touch in motion/trace.cpp.
constexpr double shortest_leave = 1e-9, longest_leave = 1e-7;

}  // namespace

std::optional<double> first_zero(EventFunction& f, double end, bool leaving) {
  if (!leaving && f.ceiling(end) < 0) return std::nullopt;
  return March(f, end, leaving).run(0);
}

std::optional<double> first_zero_after_leaving(EventFunction& f, double end) {
  const std::optional<double> zero = first_zero(f, end, true);
  if (!zero || *zero > 0) return zero;
  for (double left = shortest_leave; left <= longest_leave; left *= 10)
    if (f.move_to(left).value < 0) return March(f, end, false).run(left);
  return zero;
}

}  // namespace vcrit::simulation
