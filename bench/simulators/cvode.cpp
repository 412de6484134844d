#include "simulators/cvode.hpp"

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"
#include "linear/orthogonal.hpp"

namespace vcrit::simulators {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using simulation::Motion;

namespace {

// More events than any steady cycle has: the switching chatters.
constexpr int most_events = 400;

struct Cycle {
  double ratio = 0;
  int events = 0;
  double middle = 0;  ///< of the longest slip, time after the cycle's start
};

class CvodeSearch {
 public:
  CvodeSearch(const simulation::System& system, double velocity, const CvodeOptions& options)
      : system_(system, velocity),
        integrator_(system_, options.formula, options.relative_tolerance),
        most_periods_(options.most_periods),
        tolerance_(options.relative_tolerance) {
    state_.y = system_.at_rest();
    state_.motion = system_.motion_of(state_.y, 0);
    integrator_.restart(state_);
  }

  CvodeSteady by_marching();
  CvodeSteady by_newton();

 private:
  struct Return {
    VectorXd change;  ///< of the state after one period, without the impulse
    Cycle cycle;
  };

  void switch_motion(int event);
  bool event_is_real(int event) const;
  Cycle march(double duration);
  Return period_from(const VectorXd& y);
  MatrixXd derivative(const VectorXd& y, const VectorXd& change);
  bool improve(VectorXd& y, Return& now, const MatrixXd& map);
  bool settled(double last, double ratio);
  CvodeSteady answer(const Cycle& cycle) const { return {cycle.ratio, periods_, cycle.events}; }

  SwitchedSystem system_;
  CvodeIntegrator integrator_;
  int most_periods_;
  double tolerance_;
  SwitchedState state_;
  double phase_ = 0;        ///< where Newton's periods begin
  double last_change_ = 0;  ///< of the ratio, one period ago
  int periods_ = 0;
};

// An event function may touch zero where its motion has only begun. Then it does not fall.
bool CvodeSearch::event_is_real(int event) const {
  const Row function = event_functions(system_, state_.motion)[static_cast<std::size_t>(event)];
  return system_.rate(function, state_.motion, state_.y, state_.t) < 0;
}

void CvodeSearch::switch_motion(int event) {
  double side = state_.motion == Motion::backslip ? -1 : 1;
  if (state_.motion == Motion::stick) {
    side = event == 0 ? 1 : -1;
    state_.motion = event == 0 ? Motion::slip : Motion::backslip;
  } else {
    state_.motion = Motion::stick;
  }
  system_.project(state_.y, side * system_.bound(state_.t));
  integrator_.restart(state_);
}

Cycle CvodeSearch::march(double duration) {
  if (++periods_ > most_periods_) throw NotFinished("not finished: too many periods");
  const double begin = state_.t, end = begin + duration;
  const double impulse = state_.y(state_.y.size() - 1);
  Cycle cycle;
  double longest = 0;
  while (state_.t < end) {
    const double piece = state_.t;
    const Motion motion = state_.motion;
    const int event = integrator_.advance(end, state_);
    if (motion == Motion::slip && state_.t - piece > longest) {
      longest = state_.t - piece;
      cycle.middle = 0.5 * (piece + state_.t) - begin;
    }
    if (event < 0) continue;
    if (!event_is_real(event)) {
      integrator_.restart(state_);  // CVODE does not leave a root at which its function stays zero
      continue;
    }
    switch_motion(event);
    if (++cycle.events > most_events) throw NotFinished("chattering");
  }
  cycle.ratio = (state_.y(state_.y.size() - 1) - impulse) / duration;
  return cycle;
}

// The change that is left is the sum of a geometric series, as far as the last two periods tell.
bool CvodeSearch::settled(double last, double ratio) {
  const double change = std::abs(ratio - last);
  const double factor = change < last_change_ ? change / last_change_ : 1;
  const bool done = change == 0 || (factor < 1 && change * factor / (1 - factor) < tolerance_);
  last_change_ = change;
  return done;
}

CvodeSteady CvodeSearch::by_marching() {
  last_change_ = 0;
  Cycle cycle = march(two_pi);
  for (double last = 2; periods_ < 4 || !settled(last, cycle.ratio);) {
    last = cycle.ratio;
    cycle = march(two_pi);
  }
  return answer(cycle);
}

CvodeSearch::Return CvodeSearch::period_from(const VectorXd& y) {
  state_.t = phase_;
  state_.motion = Motion::slip;
  state_.y << y, 0;
  system_.project(state_.y, system_.bound(phase_));
  integrator_.restart(state_);
  const VectorXd start = state_.y.head(y.size());
  Return result;
  result.cycle = march(two_pi);
  result.change = state_.y.head(y.size()) - start;
  return result;
}

// Of the change over a period. The step is larger than the square root of the tolerance, which
// would balance noise with the map's bend: along slow branches the change is small against its
// noise.
MatrixXd CvodeSearch::derivative(const VectorXd& y, const VectorXd& change) {
  const double step = std::cbrt(tolerance_);
  MatrixXd result(y.size(), y.size());
  for (Index i = 0; i < y.size(); ++i) {
    VectorXd moved = y;
    moved(i) += step;
    result.col(i) = (period_from(moved).change - change) / step;
  }
  return result;
}

// Along slow branches the map is singular to rounding: there is no step along what is within it.
VectorXd shortest_solution(const MatrixXd& a, const VectorXd& right) {
  const linear::SingularValues parts = linear::singular_values(a);
  const double least = static_cast<double>(a.cols()) * epsilon * parts.sizes(0);
  VectorXd turned = parts.u.transpose() * right;
  for (Index i = 0; i < turned.size(); ++i)
    turned(i) = parts.sizes(i) > least ? turned(i) / parts.sizes(i) : 0;
  return parts.v * turned;
}

bool CvodeSearch::improve(VectorXd& y, Return& now, const MatrixXd& map) {
  const VectorXd step = shortest_solution(map, -now.change);
  for (double share = 1; share > 0.05; share /= 2) {
    const VectorXd next = y + share * step;
    const Return there = period_from(next);
    if (!(there.change.norm() < 0.9 * now.change.norm())) continue;
    y = next;
    now = there;
    return true;
  }
  return false;
}

CvodeSteady CvodeSearch::by_newton() {
  Cycle cycle;
  for (int i = 0; i < 5; ++i) cycle = march(two_pi);
  phase_ = std::fmod(cycle.middle, two_pi);
  if (cycle.middle == 0) return by_marching();
  march(cycle.middle);
  const Index n = state_.y.size() - 1;
  VectorXd y = state_.y.head(n);
  Return now = period_from(y);
  MatrixXd map = derivative(y, now.change);
  for (int i = 0; i < 20 && now.change.norm() > tolerance_; ++i) {
    const double before = now.change.norm();
    const bool improved = improve(y, now, map);
    if (!improved && before < 100 * tolerance_) break;
    if (!improved) {
      y += now.change;
      now = period_from(y);
    }
    if (now.change.norm() > 0.1 * before) map = derivative(y, now.change);
  }
  return answer(now.cycle);
}

}  // namespace

CvodeSteady cvode_steady_state(const simulation::System& system, double velocity,
                               const CvodeOptions& options) {
  CvodeSearch search(system, velocity, options);
  return options.newton ? search.by_newton() : search.by_marching();
}

}  // namespace vcrit::simulators
