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
  template <int count>
  Eigen::Array<double, count, 1> several_at(double s, Eigen::Index first) const;
  /// One at several places, which for the same reason take little longer than one place.
  template <std::size_t count>
  std::array<double, count> at_places(const std::array<double, count>& s, Eigen::Index i) const;
  double slope(double s, Eigen::Index i) const;

  /// Where pieces begin, and 1.
  const std::vector<double>& ends() const { return ends_; }

 private:
  std::size_t piece_of(double s) const;
  /// Twice the place within a piece, from -1 to 1.
  double inside(double s, std::size_t piece) const {
    return 2 * (s - ends_[piece]) / (ends_[piece + 1] - ends_[piece]) - 1;
  }

  std::vector<double> ends_;
  std::vector<Eigen::MatrixXd> coefficients_;  ///< a row a function
};

// Clenshaw's recurrence.
template <int count>
Eigen::Array<double, count, 1> Pieces::several_at(double s, Eigen::Index first) const {
  using Several = Eigen::Array<double, count, 1>;
  const std::size_t piece = piece_of(s);
  const double x = inside(s, piece);
  const auto c = coefficients_[piece].middleRows<count>(first).array();
  Several one = Several::Zero(), two = Several::Zero();
  for (Eigen::Index k = c.cols() - 1; k > 0; --k) {
    const Several next = 2 * x * one - two + c.col(k);
    two = one;
    one = next;
  }
  return x * one - two + c.col(0);
}

template <std::size_t count>
std::array<double, count> Pieces::at_places(const std::array<double, count>& s,
                                            Eigen::Index i) const {
  std::array<const double*, count> c{};
  std::array<double, count> x{}, one{}, two{};
  const Eigen::Index functions = coefficients_.front().rows();
  for (std::size_t j = 0; j < count; ++j) {
    const std::size_t piece = piece_of(s[j]);
    x[j] = inside(s[j], piece);
    c[j] = coefficients_[piece].data() + i;
  }
  for (Eigen::Index k = coefficients_.front().cols() - 1; k > 0; --k)
    for (std::size_t j = 0; j < count; ++j) {
      const double next = 2 * x[j] * one[j] - two[j] + c[j][k * functions];
      two[j] = one[j];
      one[j] = next;
    }
  for (std::size_t j = 0; j < count; ++j) one[j] = x[j] * one[j] - two[j] + c[j][0];
  return one;
}

}  // namespace vcrit::indenter
