#include "simulation/steady/steady_cycle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "base/errors.hpp"

namespace vcrit::simulation {

namespace {

constexpr double period = 2 * std::numbers::pi;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double epsilon = std::numeric_limits<double>::epsilon();

// The share of the residual by which a step may miss what was expected of it.
constexpr double good_miss = 0.3;

// How much Newton's steps are damped: less after a good one, unless it was just raised.
struct Damping {
  double value = 0;

  void lower(double miss) {
    if (raised_)
      raised_ = false;
    else if (value < least)
      value = 0;
    else
      value *= std::max(0.03, std::sqrt(miss / good_miss));
  }
  void raise(double miss) {
    if (value == 0)
      value = std::exchange(first_, 10 * least);
    else
      value *= std::clamp(std::sqrt(miss / good_miss), 2.0, 10.0);
    raised_ = true;
  }

 private:
  static constexpr double least = 1e-9;
  double first_ = 1e-4;
  bool raised_ = false;
};

class Search {
 public:
  Search(const Model& model, double velocity, State start)
      : model_(model), velocity_(velocity), state_(std::move(start)) {}

  SteadyCycle run() {
    load();
    int cycles = 2;
    for (int attempt = 0; attempt < most_attempts; ++attempt) {
      for (int i = 0; i < cycles; ++i) last_ = plain(state_, period), state_ = last_.end;
      if (stroboscope()) {
        if (auto cycle = newton()) return *cycle;
      }
      if (cycles < 1000) cycles *= 2;
    }
    throw ModelError("no steady state found: the motion still drifts after thousands of periods");
  }

 private:
  static constexpr int most_attempts = 12;
  static constexpr int most_steps = 200;

  Trace plain(const State& state, double duration) const {
    return trace(model_, velocity_, state, duration, Matrix(state.x.size(), 0));
  }

  // From rest, the drive may pull for many periods before anything slips.
  void load() { state_ = next_event_state(model_, velocity_, state_, 1e12); }

  // Puts the state into the middle of the last period's longest forward slip.
  bool stroboscope() {
    const Trace::Part* longest = nullptr;
    for (const Trace::Part& part : last_.parts)
      if (part.piece.start().motion == Motion::slip &&
          (!longest || part.duration > longest->duration))
        longest = &part;
    if (!longest) return false;
    state_ = longest->piece.after(0.5 * longest->duration);
    state_.time -= period * std::floor(state_.time / period);
    state_.x(0) = model_.bound(state_.time);  // whatever phase was lost on the way from rest
    return true;
  }

  // The period map from the stroboscope on: what is left to close the cycle, and minus its
  // derivative.
  struct Mapped {
    Trace trace;
    Vector residual;
    Matrix derivative;
    Matrix identity;  ///< in the rows of the derivative
    const State& start() const { return trace.parts.front().piece.start(); }
    double size = 0;  ///< of the residual, in units of its rounding error
    bool usable = false;
  };

  Mapped mapped(const State& state) const {
    if (contact_velocity(model_, velocity_, state) <= 0) return {};
    const Index n = state.x.size() - 1;
    Matrix changes = Matrix::Zero(n + 1, n);
    changes.bottomRows(n).setIdentity();
    Mapped result{trace(model_, velocity_, state, period, changes), {}, {}, {}, 0, false};
    result.usable = result.trace.end.motion == Motion::slip;
    if (!result.usable) return result;
    result.identity = Matrix::Identity(n, n);
    result.residual = result.trace.end.x.tail(n) - state.x.tail(n);
    result.derivative = result.identity - result.trace.changes.bottomRows(n);
    close_slow_branches(result);
    result.size = size(result.residual, state);
    return result;
  }

  // A branch of the drive that relaxes over many periods changes by k_j X - a_j G_j in one, X and
  // G_j the integrals of u and g_j. The first part is nearly all of it and belongs to the whole
  // drive; taken off in multiples of the slowest branch's change, the rest keeps its relative
  // accuracy.
  void close_slow_branches(Mapped& map) const {
    for (Index j = 1; j + 1 < model_.body_states(); ++j) {
      const auto branch = static_cast<std::size_t>(j);
      const PoleSum& drive = model_.body->drive;
      if (drive.rates[branch] >= 1) return;
      const double slow = drive.rates[branch];
      const double share = drive.weights[branch] / drive.weights[0], other = share * drive.rates[0];
      map.identity(1 + j, 1) = -share;
      map.residual(1 + j) = other * map.trace.integrals(2) - slow * map.trace.integrals(2 + j);
      map.derivative.row(1 + j) =
          slow * map.trace.integral_changes.row(2 + j) - other * map.trace.integral_changes.row(2);
    }
  }

  // In units of rounding errors.
  double size(const Vector& residual, const State& state) const {
    if (residual.size() == 0) return 0;
    return residual.cwiseQuotient(rounding(state)).cwiseAbs().maxCoeff();
  }

  // A few rounding errors of each residual over one period.
  Vector rounding(const State& state) const {
    const Index n = state.x.size() - 1, body = model_.body_states();
    Vector size = state.x.tail(n).cwiseAbs();
    if (body > 0) size(0) += velocity_ + std::abs(model_.sliding_velocity);
    size += model_.sliding_rates.cwiseAbs();
    for (Index j = 0; j + 1 < body; ++j) {
      const double rate = model_.body->drive.rates[static_cast<std::size_t>(j)];
      size(1 + j) = (1 + size(1 + j)) * (j > 0 ? std::min(1.0, period * rate) : 1.0);
    }
    for (Index j = 0; j < model_.units(); ++j)
      size(body + j) += model_.contact.unit_fluidity(j) /
                        (1 + model_.contact.unit_rates[static_cast<std::size_t>(j)]);
    return 8 * epsilon * size;
  }

  State corrected(const State& state, const Vector& step) const {
    State next = state;
    next.x.tail(step.size()) += step;
    return next;
  }

  // Newton's method, damped where the map bends: with a weight d on the identity a step goes as far
  // as 1/d plain cycles along slow directions, and d times the step is what the residual should be
  // after it. As no cycle moves two motions apart, such steps lead to the fixed point from
  // anywhere.
  std::optional<SteadyCycle> newton() {
    Mapped now = mapped(state_);
    Damping damping;
    for (int i = 0; i < most_steps && now.usable && damping.value < 10; ++i) {
      if (now.residual.size() == 0) return SteadyCycle{now.trace, ratio(now), summing(now)};
      const Eigen::FullPivLU<Matrix> solver(now.derivative + damping.value * now.identity);
      const Vector step = solver.solve(now.residual);
      if (!step.allFinite()) return std::nullopt;
      if (damping.value == 0 && now.size <= 1) return finished(now, solver, step);
      Mapped trial = mapped(corrected(state_, step));
      const Vector expected = damping.value * now.identity * step;
      const double miss =
          trial.usable ? size(trial.residual - expected, state_) / now.size : infinity;
      if (miss <= good_miss) {
        state_ = trial.start();
        now = std::move(trial);
        damping.lower(miss);
      } else if (damping.value == 0 && now.size <= 1e3) {
        return finished(now, solver, step);
      } else {
        if (!trial.usable) centre(now);
        damping.raise(miss);
      }
    }
    return std::nullopt;
  }

  // The slip may have moved away from the stroboscope on the way.
  void centre(Mapped& now) {
    last_ = now.trace;
    if (stroboscope()) now = mapped(state_);
  }

  static double ratio(const Mapped& now) { return now.trace.impulse() / period; }

  // Rounding of the mean itself, a few errors for each part that it is made of.
  static double summing(const Mapped& now) {
    return 8 * epsilon * static_cast<double>(now.trace.parts.size());
  }

  // The error left: what one more Newton step would change, and the rounding of one period as the
  // steady state amplifies it.
  SteadyCycle finished(const Mapped& now, const Eigen::FullPivLU<Matrix>& solver,
                       const Vector& step) const {
    const Vector gradient = now.trace.integral_changes.row(0).transpose();
    const Vector gain = solver.transpose().solve(gradient);
    const double left = std::abs(gradient.dot(step)) + gain.cwiseAbs().dot(rounding(state_));
    return {now.trace, ratio(now), summing(now) + left / period};
  }

  const Model& model_;
  double velocity_;
  State state_;
  Trace last_;
};

}  // namespace

SteadyCycle steady_cycle(const Model& model, double velocity, State start) {
  return Search(model, velocity, std::move(start)).run();
}

}  // namespace vcrit::simulation
