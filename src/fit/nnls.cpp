#include "fit/nnls.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "base/constants.hpp"
#include "base/interruption.hpp"
#include "linear/orthogonal.hpp"

namespace vcrit::fit {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

class ActiveSet {
 public:
  // Columns of one length, so that a gradient is a cosine and rounding is the same in all.
  ActiveSet(const MatrixXd& a, const VectorXd& b)
      : size_(a.colwise().norm().cwiseMax(std::numeric_limits<double>::min())),
        a_(a * size_.cwiseInverse().asDiagonal()),
        b_(b),
        x_(VectorXd::Zero(a.cols())) {}

  VectorXd solve() {
    // Each step frees the steepest column; three times as many as there are columns always do.
    for (Index step = 0; step < 3 * a_.cols() + 3; ++step) {
      hear_interruption();
      const Index steepest = steepest_bound_column();
      if (steepest < 0) break;
      free_.push_back(steepest);
      descend();
    }
    return x_.cwiseQuotient(size_);
  }

 private:
  static bool among(const std::vector<Index>& columns, Index column) {
    return std::find(columns.begin(), columns.end(), column) != columns.end();
  }

  Index steepest_bound_column() const {
    const VectorXd residual = b_ - a_ * x_;
    const VectorXd gradient = a_.transpose() * residual;
    // A cosine below the rounding of its own sum is none.
    double steepest = 32 * epsilon * b_.norm();
    Index found = -1;
    for (Index i = 0; i < a_.cols(); ++i)
      if (gradient[i] > steepest && !among(free_, i) && !among(refused_, i))
        steepest = gradient[i], found = i;
    return found;
  }

  VectorXd free_solution() const {
    MatrixXd columns(a_.rows(), static_cast<Index>(free_.size()));
    for (std::size_t i = 0; i < free_.size(); ++i)
      columns.col(static_cast<Index>(i)) = a_.col(free_[i]);
    return linear::PivotedQr(columns).solve(b_);
  }

  // To the least squares of the free columns, binding again those that become 0 on the way. Where
  // the new column comes out at 0 at once it was no descent but rounding.
  void descend() {
    VectorXd target = free_solution();
    if (!(target[target.size() - 1] > 0)) {
      refused_.push_back(free_.back());
      free_.pop_back();
      return;
    }
    refused_.clear();
    while (target.size() > 0 && target.minCoeff() <= 0) {
      move_towards(target);
      target = free_solution();
    }
    for (std::size_t i = 0; i < free_.size(); ++i) x_[free_[i]] = target[static_cast<Index>(i)];
  }

  void move_towards(const VectorXd& target) {
    double part = 1;
    Index first = -1;
    for (std::size_t i = 0; i < free_.size(); ++i) {
      const double from = x_[free_[i]], to = target[static_cast<Index>(i)];
      if (to > 0 || from / (from - to) > part) continue;
      part = from / (from - to);
      first = free_[i];
    }
    for (std::size_t i = 0; i < free_.size(); ++i)
      x_[free_[i]] += part * (target[static_cast<Index>(i)] - x_[free_[i]]);
    std::erase_if(free_, [&](Index i) {
      const bool bound = i == first || x_[i] <= 0;
      if (bound) x_[i] = 0;
      return bound;
    });
  }

  VectorXd size_;
  MatrixXd a_;
  VectorXd b_, x_;
  std::vector<Index> free_, refused_;
};

}  // namespace

VectorXd nonnegative_least_squares(const MatrixXd& a, const VectorXd& b) {
  return ActiveSet(a, b).solve();
}

}  // namespace vcrit::fit
