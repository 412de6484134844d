// Functions of [0, 1], several at once, as Chebyshev polynomials on pieces that are halved where
// one polynomial is not enough.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
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
  double at(double s, Eigen::Index i) const { return several_at<1>(s, i)[0]; }
  /// Those from `first` on. Side by side they take little longer than one, which waits for itself.
  template <std::size_t count>
  std::array<double, count> several_at(double s, Eigen::Index first) const;
  double slope(double s, Eigen::Index i) const;

  /// Where pieces begin, and 1.
  const std::vector<double>& ends() const { return ends_; }

 private:
  std::size_t piece_of(double s) const;

  std::vector<double> ends_;
  std::vector<Eigen::MatrixXd> coefficients_;  ///< a column a function
};

// Clenshaw's recurrence.
template <std::size_t count>
std::array<double, count> Pieces::several_at(double s, Eigen::Index first) const {
  const std::size_t piece = piece_of(s);
  const Eigen::MatrixXd& all = coefficients_[piece];
  const Eigen::Index rows = all.rows();
  const double* c = all.data() + first * rows;
  const double x = 2 * (s - ends_[piece]) / (ends_[piece + 1] - ends_[piece]) - 1;
  std::array<double, count> one{}, two{};
  for (Eigen::Index k = rows - 1; k > 0; --k)
    for (std::size_t j = 0; j < count; ++j) {
      const double next = 2 * x * one[j] - two[j] + c[static_cast<Eigen::Index>(j) * rows + k];
      two[j] = one[j];
      one[j] = next;
    }
  for (std::size_t j = 0; j < count; ++j)
    one[j] = x * one[j] - two[j] + c[static_cast<Eigen::Index>(j) * rows];
  return one;
}

}  // namespace vcrit::indenter
