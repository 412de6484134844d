#include "simulation/methods/steady.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "base/errors.hpp"
#include "base/interruption.hpp"
#include "simulation/methods/newton.hpp"

namespace vcrit::simulation::methods {

namespace {

// Of a mean over the thousands of steps in a period.
constexpr double ratio_rounding = 1e-14;

Regime regime(const Period& period) {
  const auto there = [&](Motion motion) {
    return std::any_of(period.events.begin(), period.events.end(),
                       [&](const Event& event) { return event.to == motion; });
  };
  const bool separated = there(Motion::separated);
  if (there(Motion::backslip))
    return separated ? Regime::stick_slip_backslip_separated : Regime::stick_slip_backslip;
  if (there(Motion::stick)) return separated ? Regime::stick_slip_separated : Regime::stick_slip;
  if (separated) return Regime::sliding_separated;
  return period.end.motion == Motion::stick ? Regime::stick : Regime::sliding;
}

// Plain periods never lead away from the steady cycle: where Newton's method fails, more of them go
// first. A long step may have set right what is slow and upset what is fast, which comes to rest by
// itself: some such steps are taken.
SteadyState by_newton(Periods& periods, MapState state) {
  constexpr int most_jumps = 4;
  int jumps = 0;
  for (int count = 4;;) {
    for (int i = 0; i < count; ++i) state = periods.run(state).end;
    state = periods.map().to_smooth_section(state);
    Newton newton(periods, std::move(state));
    if (newton.converges()) return newton.found();
    if (newton.rejected() && jumps++ < most_jumps) {
      state = *newton.rejected();
    } else {
      state = newton.best();
      count *= 2;
    }
  }
}

}  // namespace

Period Periods::run(const MapState& state, PeriodAccuracy accuracy) {
  hear_interruption();
  if (++count_ > most_)
    throw ModelError(fmt::format("has not settled after {} periods{}", most_, progress_));
  return map_.run(state, accuracy);
}

Eigen::VectorXd Periods::change(const MapState& begin, const Period& period) const {
  const std::vector<Eigen::Index> variables = map_.variables(begin);
  Eigen::VectorXd result(static_cast<Eigen::Index>(variables.size()));
  for (Eigen::Index i = 0; i < result.size(); ++i) {
    const Eigen::Index variable = variables[static_cast<std::size_t>(i)];
    result(i) = (period.end.y(variable) - begin.y(variable)) / map_.scale(variable);
  }
  return result;
}

bool may_hide_stick(const Period& period, const Period& coarse, double growth) {
  if (!period.slides() || period.slowest == infinity) return false;
  const double error = caution * growth * std::abs(coarse.slowest - period.slowest);
  return !coarse.slides() || period.slowest <= error;
}

SteadyState answer(Period period, double error) {
  SteadyState state;
  state.friction_ratio = 1 - period.deficit;
  state.friction_ratio_error = error + ratio_rounding;
  state.regime = regime(period);
  state.periods = 1;
  state.events = std::move(period.events);
  std::sort(state.events.begin(), state.events.end(),
            [](const Event& a, const Event& b) { return a.phase < b.phase; });
  return state;
}

SteadyState settle(PeriodMap& map, const MethodOptions& options) {
  Periods periods(map, options.most_periods);
  MapState state = map.start(options.start);
  SteadyState found = options.newton ? by_newton(periods, std::move(state))
                                     : plain_periods(periods, std::move(state));
  found.friction_ratio_error += map.resolution();
  // Its work is the drive's: of a motion that repeats, it is not below 0.
  if (found.friction_ratio < -found.friction_ratio_error)
    throw ModelError(
        "has not settled: friction pushes the drive on, as it does in no steady motion");
  return found;
}

}  // namespace vcrit::simulation::methods
