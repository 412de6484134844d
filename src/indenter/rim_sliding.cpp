#include "indenter/rim_sliding.hpp"

#include <Eigen/Core>
#include <algorithm>

#include "base/constants.hpp"
#include "linear/orthogonal.hpp"

namespace vcrit::indenter {

Sliding::Sliding(const ScaledContact& contact, const ScaledHolder& holder, double tolerance,
                 SharedEffort* whole)
    : motion_(contact, holder, 0, tolerance, whole, true), contact_(contact) {
  find();
}

double Sliding::mean_force() const { return motion_.impulse() / two_pi; }

double Sliding::mean_speed() const { return motion_.travel() / two_pi; }

double Sliding::largest() const {
  double most = -infinity;
  for (const TimeStep& step : motion_.kept()) most = std::max(most, largest_in(step));
  return most;
}

StateVector Sliding::after(const StateVector& body) {
  motion_.start(0, body);
  motion_.run(two_pi);
  return motion_.body();
}

// What the period does is linear in the body's numbers. Where its first spring takes what is left
// of the friction, that number is none.
void Sliding::find() {
  const Eigen::Index n = motion_.size();
  const StateVector zero = StateVector::Zero(n), base = after(zero);
  if (n == 0) return;  // a damper alone
  Eigen::MatrixXd map(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    StateVector unit = zero;
    unit(i) = 1;
    map.col(i) = unit - (after(unit) - base);
  }
  if (motion_.first_given()) {
    map.row(0).setZero();
    map.col(0).setZero();
    map(0, 0) = 1;
  }
  // Numbers that a period gives back are forces that relax over more than 1e13 periods: of springs
  // side by side, of which the body feels the sum. They may be shared out in any way, and of the
  // sum a period takes no more than that share.
  constexpr double no_return = 1e-13;
  const Eigen::VectorXd weights = motion_.energy_weights();
  const linear::SingularValues parts =
      linear::singular_values(weights.asDiagonal() * map * weights.cwiseInverse().asDiagonal());
  Eigen::VectorXd found = parts.u.transpose() * weights.cwiseProduct(base);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double size = parts.sizes(i);
    found(i) = size < no_return ? 0 : found(i) / size;
  }
  body_ = (parts.v * found).cwiseQuotient(weights);
  after(body_);
}

double Sliding::rise(double t, const TimeStep& step) const {
  return contact_.depth_rate(t) - motion_.speed(t, step);
}

// The largest of samples, then by thirds, to where the maximum is flat.
double Sliding::largest_in(const TimeStep& step) const {
  const double length = step.end() - step.begin();
  if (!contact_.touches(step.begin() + 0.5 * length)) return -infinity;
  constexpr int samples = 16;
  int best = 0;
  double most = -infinity;
  for (int i = 0; i <= samples; ++i)
    if (const double found = rise(step.begin() + length * i / samples, step); found > most) {
      most = found;
      best = i;
    }
  double low = step.begin() + length * std::max(0, best - 1) / samples;
  double high = step.begin() + length * std::min(samples, best + 1) / samples;
  for (int i = 0; i < 60; ++i) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    const double at_a = rise(a, step), at_b = rise(b, step);
    most = std::max({most, at_a, at_b});
    (at_a < at_b ? low : high) = at_a < at_b ? a : b;
  }
  return most;
}

}  // namespace vcrit::indenter
