// A polynomial in Bernstein's form on an interval: it lies in the convex hull of its coefficients,
// so their signs prove its own, and the hull's first crossing is a bound on its first zero.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace vcrit::simulation {

inline constexpr std::size_t degree = 5;

/// Derivatives c_0..c_5 at x = 0 of sum_k c_k x^k/k!.
using Derivatives = std::array<double, degree + 1>;

class Bernstein {
 public:
  /// On [0, h].
  Bernstein(const Derivatives& c, double h) {
    std::array<double, degree + 1> term{};
    double power = 1;
    for (std::size_t k = 0; k <= degree; ++k) {
      term[k] = c[k] * power;
      power *= h / static_cast<double>(degree - k);  // h^k (n-k)!/n!, for C(i,k)/C(n,k)/k!
    }
    for (std::size_t i = 0; i <= degree; ++i)
      for (std::size_t k = 0; k <= i; ++k) b_[i] += binomial[i][k] * term[k];
  }

  /// The share of the interval from 0 on, x = 0 apart, over which the polynomial is certainly
  /// negative; short of its first zero by a relative 1e-8 or so.
  double negative_share() {
    divide_by_zeros();
    if (!(b_[0] < 0)) return 0;
    double from = 0;
    for (int i = 0; i < 60; ++i) {
      const double step = hull_crossing();
      if (step >= 1) return 1;
      const double advance = (1 - from) * step;
      from += advance;
      if (advance < 1e-5 * from) break;
      cut(step);
    }
    return from;
  }

 private:
  static constexpr auto binomial = [] {
    std::array<std::array<double, degree + 1>, degree + 1> table{};
    for (std::size_t i = 0; i <= degree; ++i)
      for (std::size_t k = 0; k <= i; ++k)
        table[i][k] = k == 0 || k == i ? 1 : table[i - 1][k - 1] + table[i - 1][k];
    return table;
  }();

  // n/i
  static constexpr auto stretch = [] {
    std::array<std::array<double, degree + 1>, degree + 1> table{};
    for (std::size_t n = 1; n <= degree; ++n)
      for (std::size_t i = 1; i <= n; ++i)
        table[n][i] = static_cast<double>(n) / static_cast<double>(i);
    return table;
  }();

  // A zero at x = 0 is divided out: x Q(x) has the coefficients (i/n) Q_{i-1}.
  void divide_by_zeros() {
    while (b_[0] == 0 && n_ > 1) {
      for (std::size_t i = 0; i < n_; ++i) b_[i] = b_[i + 1] * stretch[n_][i + 1];
      --n_;
    }
  }

  // Where the hull of the points (i/n, b_i) reaches 0 at the earliest: along its steepest line from
  // the first of them.
  double hull_crossing() const {
    double steepest = -b_[0];
    for (std::size_t i = 1; i <= n_; ++i)
      steepest = std::max(steepest, (b_[i] - b_[0]) * stretch[n_][i]);
    return -b_[0] / steepest;
  }

  // De Casteljau: the same polynomial on [share, 1].
  void cut(double share) {
    for (std::size_t level = n_; level > 0; --level)
      for (std::size_t i = 0; i < level; ++i) b_[i] += share * (b_[i + 1] - b_[i]);
  }

  std::size_t n_ = degree;
  std::array<double, degree + 1> b_{};
};

}  // namespace vcrit::simulation
