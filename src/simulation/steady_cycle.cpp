#include "simulation/steady_cycle.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "base/errors.hpp"

namespace vcrit::simulation {

namespace {

constexpr double period = 2 * std::numbers::pi;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

class Search {
 public:
  Search(const Model& model, double velocity, State start)
      : model_(model), velocity_(velocity), state_(std::move(start)) {}

  SteadyCycle run() {
    load();
    int cycles = 3;
    for (int attempt = 0; attempt < most_attempts; ++attempt) {
      for (int i = 0; i < cycles; ++i) last_ = plain(state_, period), state_ = last_.end;
      if (stroboscope()) {
        if (auto cycle = newton()) return *cycle;
      }
      if (cycles < 1000) cycles *= 2;
    }
    return window(1000);
  }

 private:
  static constexpr int most_attempts = 12;

  Trace plain(const State& state, double duration) const {
    return trace(model_, velocity_, state, duration, Matrix(state.x.size(), 0));
  }

  // From rest, the drive may pull for many periods before anything slips.
  void load() { state_ = next_event_state(model_, velocity_, state_, 1e12); }

  // Puts the state into the middle of the last period's longest forward slip.
  bool stroboscope() {
    double longest = 0, middle = 0;
    for (const Trace::Part& part : last_.parts) {
      if (part.piece.start().motion != Motion::slip || part.duration <= longest) continue;
      longest = part.duration;
      middle = part.piece.start().time + 0.5 * part.duration;
    }
    if (longest == 0) return false;
    const double wait = middle + period - state_.time;
    state_ = plain(state_, wait > period ? wait - period : wait).end;
    state_.time -= period * std::floor(state_.time / period);
    return state_.motion == Motion::slip;
  }

  // The period map from the stroboscope on, with its derivative.
  struct Mapped {
    Trace trace;
    Vector residual;
    bool usable = false;
    double norm() const { return residual.size() == 0 ? 0 : residual.lpNorm<Eigen::Infinity>(); }
  };

  Mapped mapped(const State& state) const {
    if (contact_velocity(model_, velocity_, state) <= 0) return {};
    const Index n = state.x.size();
    Matrix changes = Matrix::Zero(n, n - 1);
    changes.bottomRows(n - 1).setIdentity();
    Mapped result{trace(model_, velocity_, state, period, changes), {}, false};
    result.usable = result.trace.end.motion == Motion::slip;
    if (result.usable) result.residual = result.trace.end.x.tail(n - 1) - state.x.tail(n - 1);
    return result;
  }

  State corrected(const State& state, const Vector& step) const {
    State next = state;
    next.x.tail(step.size()) += step;
    return next;
  }

  std::optional<SteadyCycle> newton() {
    Mapped now = mapped(state_);
    for (int i = 0; i < 40 && now.usable; ++i) {
      const Index n = now.residual.size();
      const Matrix derivative = Matrix::Identity(n, n) - now.trace.changes.bottomRows(n);
      const Eigen::FullPivLU<Matrix> solver(derivative);
      const Vector step = n == 0 ? Vector() : Vector(solver.solve(now.residual));
      if (n == 0 || now.norm() <= floor(state_)) return finished(now, solver, step);
      if (!step.allFinite()) return std::nullopt;
      if (!advance(now, step)) {
        if (now.norm() <= 1e3 * floor(state_)) return finished(now, solver, step);
        return std::nullopt;
      }
    }
    return std::nullopt;
  }

  // Takes the longest of the shortened steps that lowers the residual.
  bool advance(Mapped& now, const Vector& step) {
    for (double share = 1; share > 0.05; share /= 2) {
      const State next = corrected(state_, share * step);
      Mapped trial = mapped(next);
      if (!trial.usable || trial.norm() >= (1 - 0.25 * share) * now.norm()) continue;
      state_ = next;
      now = std::move(trial);
      return true;
    }
    return false;
  }

  double floor(const State& state) const {
    return 4 * epsilon * (velocity_ + 1 + state.x.lpNorm<Eigen::Infinity>());
  }

  // The error left: what one more Newton step would change, and the rounding of one period as the
  // steady state amplifies it.
  SteadyCycle finished(const Mapped& now, const Eigen::FullPivLU<Matrix>& solver,
                       const Vector& step) const {
    SteadyCycle cycle{now.trace, now.trace.impulse / period, 4 * epsilon, true};
    if (step.size() == 0) return cycle;
    const Vector gradient = now.trace.impulse_changes.transpose();
    const Vector gain = solver.transpose().solve(gradient);
    cycle.error +=
        (std::abs(gradient.dot(step)) + gain.lpNorm<1>() * floor(state_)) / period;
    return cycle;
  }

  // Where no closed cycle is found: the mean over a long window, uncertain by what it still drifts.
  SteadyCycle window(int cycles) {
    SteadyCycle cycle;
    double halves[2] = {0, 0};
    for (int i = 0; i < 2 * cycles; ++i) {
      cycle.period = plain(state_, period);
      state_ = cycle.period.end;
      halves[i / cycles] += cycle.period.impulse / period / cycles;
    }
    cycle.ratio = 0.5 * (halves[0] + halves[1]);
    cycle.error = std::abs(halves[1] - halves[0]) + 1.0 / cycles;
    return cycle;
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
