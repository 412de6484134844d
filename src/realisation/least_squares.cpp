#include "realisation/least_squares.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/interruption.hpp"
#include "linear/orthogonal.hpp"

namespace vcrit::realisation {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

class Descent {
 public:
  Descent(const LeastSquares& problem, VectorXd start)
      : problem_(problem), at_(std::move(start)), scale_(VectorXd::Zero(at_.size())) {
    problem_.keep_in_reach(at_);
    problem_.residual(at_, residual_, &slope_);
    sum_ = sum_of(residual_);
  }

  Minimum run(int steps, double enough) {
    int idle = 0;
    for (int step = 0; step < steps && std::isfinite(sum_) && sum_ > enough && idle < 3; ++step) {
      hear_interruption();
      const double before = sum_;
      if (!descend()) break;
      idle = sum_ > before * (1 - little_gain) ? idle + 1 : 0;
    }
    return {at_, sum_};
  }

 private:
  static double sum_of(const VectorXd& residual) {
    const double sum = residual.squaredNorm();
    return std::isfinite(sum) ? sum : std::numeric_limits<double>::infinity();
  }

  // After three such small gains in a row the search ends.
  static constexpr double little_gain = 1e-4;
  // A parameter that enters by its square has no derivative at 0: a step by its own scale would be
  // without bound, and rejected until no other one is left to move. A millionth of the largest
  // leaves room for the logarithm of a time of which the rows tell six digits less.
  static constexpr double least_scale = 1e-6;

  /// One step that lessens the sum, with as much damping as that takes; false where none does.
  bool descend() {
    if (!slope_.allFinite()) return false;
    scale_ = scale_.cwiseMax(slope_.colwise().norm().transpose());
    const VectorXd scale = scale_.cwiseMax(least_scale * scale_.maxCoeff());
    if (!(scale.maxCoeff() > 0)) return false;
    const linear::Qr qr(slope_);
    const Index count = at_.size(), rank = std::min(count, slope_.rows());
    MatrixXd stacked = MatrixXd::Zero(rank + count, count);
    VectorXd right = VectorXd::Zero(rank + count);
    right.head(rank) = -qr.turned(residual_).head(rank);
    constexpr int most_dampings = 14;
    for (int attempt = 0; attempt < most_dampings; ++attempt) {
      stacked.topRows(rank) = qr.upper();
      stacked.bottomRows(count) = (std::sqrt(damping_) * scale).asDiagonal();
      if (accept(linear::Qr(stacked).solve(right), scale)) return true;
      damping_ *= growth_;
      growth_ *= 2;
    }
    return false;
  }

  bool accept(const VectorXd& step, const VectorXd& scale) {
    if (!step.allFinite()) return false;
    VectorXd next = at_ + step;
    problem_.keep_in_reach(next);
    problem_.residual(next, next_residual_, &next_slope_);
    const double sum = sum_of(next_residual_);
    if (!(sum < sum_)) return false;
    const double promised = sum_ - (residual_ + slope_ * step).squaredNorm() +
                            damping_ * scale.cwiseProduct(step).squaredNorm();
    const double kept = promised > 0 ? (sum_ - sum) / promised : 0;
    damping_ = std::max(damping_ * std::max(1.0 / 3, 1 - std::pow(2 * kept - 1, 3)), 1e-15);
    growth_ = 2;
    at_ = std::move(next);
    residual_.swap(next_residual_);
    slope_.swap(next_slope_);
    sum_ = sum;
    return true;
  }

  const LeastSquares& problem_;
  VectorXd at_, residual_, next_residual_, scale_;
  MatrixXd slope_, next_slope_;
  double sum_ = 0, damping_ = 1e-3, growth_ = 2;
};

}  // namespace

Minimum minimise(const LeastSquares& problem, VectorXd start, int steps, double enough) {
  return Descent(problem, std::move(start)).run(steps, enough);
}

}  // namespace vcrit::realisation
