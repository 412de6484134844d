// Functions of [0, 1], several at once, as Chebyshev polynomials on pieces that are halved where
// one polynomial is not enough.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace vcrit::indenter {

class Pieces {
 public:
  /// Writes all values at a place inside (0, 1).
  using Functions = std::function<void(double s, Eigen::VectorXd& values)>;

  Pieces() = default;
  /// tolerance: on each function, relative to its largest value.
  Pieces(const Functions& functions, Eigen::Index count, double tolerance);

  /// All of them, s in [0, 1].
  void at(double s, Eigen::VectorXd& values) const;
  double at(double s, Eigen::Index i) const;
  double slope(double s, Eigen::Index i) const;

  /// Where pieces begin, and 1.
  const std::vector<double>& ends() const { return ends_; }

 private:
  std::size_t piece_of(double s) const;

  std::vector<double> ends_;
  std::vector<Eigen::MatrixXd> coefficients_;  ///< a column a function
};

}  // namespace vcrit::indenter
