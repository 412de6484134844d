#include "simulation/methods/newton.hpp"

#include <cmath>

#include "linear/elimination.hpp"

namespace vcrit::simulation::methods {

namespace {

// From where it converges the digits double with each, in six steps at most; before, it may creep.
constexpr int most_newton_steps = 12;

}  // namespace

Newton::Newton(Periods& periods, MapState start)
    : periods_(periods),
      state_(std::move(start)),
      variables_(periods.map().variables(state_)),
      period_(periods.run(state_)),
      rest_(periods.change(state_, period_)) {
  differentiate();
}

bool Newton::converges() {
  for (int i = 0; i < most_newton_steps; ++i) {
    solve();
    if (done()) return true;
    if (!step_.allFinite() || !advance()) return false;
  }
  return false;
}

// One more period with less accuracy tells the integrator's error, carried to the steady cycle.
SteadyState Newton::found() {
  const Period coarse = periods_.run(state_, PeriodAccuracy::coarser);
  const MapVector moved_on = solver_.solve(MapVector(periods_.change(state_, coarse) - rest_));
  const double apart = coarse.deficit - period_.deficit + deficit_by_begin_.dot(moved_on);
  double error = caution * std::abs(apart) + std::abs(deficit_by_begin_.dot(step_));
  if (period_.slides() &&
      may_hide_stick(period_, periods_.run(moved(moved_on), PeriodAccuracy::coarser)))
    error += missed_stick;
  return answer(std::move(period_), error);
}

MapState Newton::moved(const MapVector& by) const {
  MapState state = state_;
  for (Eigen::Index i = 0; i < by.size(); ++i) {
    const Eigen::Index variable = variables_[static_cast<std::size_t>(i)];
    state.y(variable) += by(i) * periods_.map().scale(variable);
  }
  return state;
}

void Newton::differentiate() {
  const Eigen::Index n = rest_.size();
  const double step = std::sqrt(periods_.map().noise());
  end_by_begin_.resize(n, n);
  deficit_by_begin_.resize(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Period other = periods_.run(moved(step * MapVector::Unit(n, i)));
    end_by_begin_.col(i) = (periods_.change(state_, other) - rest_) / step;
    deficit_by_begin_(i) = (other.deficit - period_.deficit) / step;
  }
}

void Newton::solve() {
  const Eigen::Index n = rest_.size();
  solver_ = linear::Lu<double>(Eigen::MatrixXd::Identity(n, n) - end_by_begin_);
  step_ = solver_.solve(rest_);
}

bool Newton::close() const {
  return rest_.size() == 0 || rest_.cwiseAbs().maxCoeff() <= 20 * periods_.map().noise();
}

bool Newton::done() const {
  if (!close()) return false;
  // Friction says nothing of a motion that slides, however far from where it must go.
  const double moves =
      period_.events.empty() ? step_.norm() : std::abs(deficit_by_begin_.dot(step_));
  return stalled_ || moves <= 0.1 * periods_.map().noise();
}

bool Newton::advance() {
  MapState next = moved(step_);
  Period after = periods_.run(next);
  const MapVector left = periods_.change(next, after);
  if (after.end.motion != next.motion || (!close() && !(left.norm() < rest_.norm()))) {
    rejected_ = std::move(after.end);
    return false;
  }
  stalled_ = left.norm() > 0.3 * rest_.norm();
  update(after);
  state_ = std::move(next);
  period_ = std::move(after);
  rest_ = left;
  if (stalled_ && !close()) differentiate();
  return true;
}

void Newton::update(const Period& after) {
  const double square = step_.squaredNorm();
  if (square == 0) return;
  const MapVector miss = periods_.change(state_, after) - rest_ - end_by_begin_ * step_;
  const double missed = after.deficit - period_.deficit - deficit_by_begin_.dot(step_);
  end_by_begin_ += miss * step_.transpose() / square;
  deficit_by_begin_ += missed * step_.transpose() / square;
}

}  // namespace vcrit::simulation::methods
