#include "simulation/methods/steady.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/errors.hpp"

namespace vcrit::simulation::methods {

namespace {

using Eigen::Index;
using Vector = Eigen::VectorXd;

constexpr int newton_steps = 12;
constexpr int most_jumps = 4;
constexpr double rounding = 1e-14;

// Errors follow tolerance and step only roughly.
constexpr double caution = 2;
constexpr double turn = 2 * std::numbers::pi;
constexpr double infinite = std::numeric_limits<double>::infinity();

Regime regime(const Period& period) {
  const auto is_backslip = [](const Event& event) { return event.to == Motion::backslip; };
  if (std::any_of(period.events.begin(), period.events.end(), is_backslip))
    return Regime::stick_slip_backslip;
  if (!period.events.empty()) return Regime::stick_slip;
  return period.end.motion == Motion::stick ? Regime::stick : Regime::sliding;
}

SteadyState answer(Period period, double error) {
  SteadyState state;
  state.friction_ratio = 1 - period.deficit;
  state.friction_ratio_error = error + rounding;
  state.regime = regime(period);
  state.periods = 1;
  state.events = std::move(period.events);
  std::sort(state.events.begin(), state.events.end(),
            [](const Event& a, const Event& b) { return a.phase < b.phase; });
  return state;
}

/// Change of end and deficit of a period with the scaled variables of its beginning.
struct Derivative {
  Eigen::MatrixXd end;
  Eigen::RowVectorXd deficit;
};

class Search {
 public:
  Search(PeriodMap& map, const MethodOptions& options) : map_(map), options_(options) {}

  SteadyState find() {
    State state = map_.start(options_.start);
    if (!options_.newton) return plain(state);
    for (int periods = 4;;) {
      for (int i = 0; i < periods; ++i) state = run(state).end;
      state = map_.to_smooth_section(state);
      const int jumps = jumps_;
      if (const auto found = newton(state)) return *found;
      if (jumps_ == jumps || jumps_ > most_jumps) periods *= 2;
    }
  }

 private:
  Period run(const State& state, Accuracy accuracy = Accuracy::asked) {
    if (++periods_ > options_.most_periods)
      throw ModelError(
          fmt::format("has not settled after {} periods{}", options_.most_periods, last_));
    return map_.run(state, accuracy);
  }

  // Spread of 1 - mu_macro/mu0 over the periods from `begin` on.
  double spread(std::size_t begin, std::size_t count) const {
    const auto first = deficits_.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto [low, high] = std::minmax_element(first, first + static_cast<std::ptrdiff_t>(count));
    return *high - *low;
  }

  // What is still to come if the spread goes on falling as it did between the last two quarters.
  double trend() const {
    const std::size_t size = deficits_.size(), quarter = size / 4;
    const double late = spread(size - quarter, quarter);
    const double early = spread(size - 2 * quarter, quarter);
    if (early <= 2 * map_.noise()) return late;
    const double share = late / early;
    return share < 1 ? late * std::max(0.5, share / (1 - share)) : infinite;
  }

  // The same if all of it is the beginning of the slowest relaxation, which a trend shows too late.
  double slowest_trend() const {
    const std::size_t quarter = deficits_.size() / 4;
    return spread(deficits_.size() - quarter, quarter) * slowness(quarter - 1);
  }

  double slowness(std::size_t periods) const {
    return 1 / -std::expm1(-turn * map_.slowest_rate() * static_cast<double>(periods));
  }

  // Friction says nothing of a motion that slides: its state must come to rest.
  bool still(const State& begin, const Period& period) const {
    if (!period.events.empty()) return true;
    const std::vector<Index> variables = map_.variables(begin);
    const Vector rest = scaled(period.end.y - begin.y, variables);
    return rest.size() == 0 || rest.cwiseAbs().maxCoeff() * slowness(1) <= map_.target();
  }

  SteadyState plain(State state) {
    for (std::size_t check = 12;; check += check / 4) {
      State begin;
      Period period;
      while (deficits_.size() < check) {
        begin = state;
        period = run(state);
        state = period.end;
        deficits_.push_back(period.deficit);
      }
      const double left = trend();
      const bool at_rest = still(begin, period);
      last_ = at_rest ? fmt::format(
                            ": by its trend the friction ratio would still change by {:.1g}", left)
                      : std::string(": it slides all the time, but its state still moves");
      if (left > map_.target() || !at_rest) continue;
      const Period coarse = map_.run(begin, Accuracy::coarser);
      const double error = caution * std::abs(coarse.deficit - period.deficit);
      return answer(std::move(period), error + caution * std::max(left, slowest_trend()));
    }
  }

  Vector scaled(const Vector& y, const std::vector<Index>& variables) const {
    Vector x(static_cast<Index>(variables.size()));
    for (Index i = 0; i < x.size(); ++i) {
      const Index variable = variables[static_cast<std::size_t>(i)];
      x(i) = y(variable) / map_.scale(variable);
    }
    return x;
  }

  State moved(State state, const std::vector<Index>& variables, const Vector& by) const {
    for (Index i = 0; i < by.size(); ++i) {
      const Index variable = variables[static_cast<std::size_t>(i)];
      state.y(variable) += by(i) * map_.scale(variable);
    }
    return state;
  }

  Derivative differences(const State& state, const std::vector<Index>& variables,
                         const Period& period) {
    const auto n = static_cast<Index>(variables.size());
    const double step = std::sqrt(map_.noise());
    Derivative derivative{Eigen::MatrixXd(n, n), Eigen::RowVectorXd(n)};
    for (Index i = 0; i < n; ++i) {
      const Period other = run(moved(state, variables, step * Vector::Unit(n, i)));
      derivative.end.col(i) = scaled(other.end.y - period.end.y, variables) / step;
      derivative.deficit(i) = (other.deficit - period.deficit) / step;
    }
    return derivative;
  }

  // Newton's method; Broyden's update between two derivatives. Nothing where it does not converge:
  // then plain periods, which never lead away from the steady cycle, go first. A long step may have
  // set right what is slow and upset what is fast, which comes to rest by itself: some are taken.
  std::optional<SteadyState> newton(State& state) {
    const std::vector<Index> variables = map_.variables(state);
    Period period = run(state);
    Vector rest = scaled(period.end.y - state.y, variables);
    Derivative derivative = differences(state, variables, period);
    const auto n = rest.size();
    bool stalled = false;
    for (int i = 0; i < newton_steps; ++i) {
      const auto solver = (Eigen::MatrixXd::Identity(n, n) - derivative.end).partialPivLu();
      const Vector step = solver.solve(rest);
      const double change = std::abs(derivative.deficit.dot(step));
      const bool close = n == 0 || rest.cwiseAbs().maxCoeff() <= 20 * map_.noise();
      // Friction says nothing of a motion that slides, however far from where it must go.
      const double moves = period.events.empty() ? step.norm() : change;
      if (close && (moves <= 0.1 * map_.noise() || stalled)) {
        const Period coarse = run(state, Accuracy::coarser);
        const Vector apart = solver.solve(scaled(coarse.end.y - period.end.y, variables));
        const double apart_in_deficit =
            coarse.deficit - period.deficit + derivative.deficit.dot(apart);
        return answer(std::move(period), caution * std::abs(apart_in_deficit) + change);
      }
      if (!step.allFinite()) return std::nullopt;
      State next = moved(state, variables, step);
      Period after = run(next);
      const Vector left = scaled(after.end.y - next.y, variables);
      if (after.end.motion != next.motion || (!close && !(left.norm() < rest.norm()))) {
        if (jumps_++ < most_jumps) state = std::move(after.end);
        return std::nullopt;
      }
      stalled = left.norm() > 0.3 * rest.norm();
      const double square = step.squaredNorm();
      if (square > 0) {
        const Vector miss = scaled(after.end.y - period.end.y, variables) - derivative.end * step;
        const double missed = after.deficit - period.deficit - derivative.deficit.dot(step);
        derivative.end += miss * step.transpose() / square;
        derivative.deficit += missed * step.transpose() / square;
      }
      state = std::move(next);
      period = std::move(after);
      rest = left;
      if (stalled && !close) derivative = differences(state, variables, period);
    }
    return std::nullopt;
  }

  PeriodMap& map_;
  const MethodOptions& options_;
  int periods_ = 0, jumps_ = 0;
  std::vector<double> deficits_;
  std::string last_;
};

}  // namespace

SteadyState settle(PeriodMap& map, const MethodOptions& options) {
  return Search(map, options).find();
}

}  // namespace vcrit::simulation::methods
