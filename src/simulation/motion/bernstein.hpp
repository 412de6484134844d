// How long a polynomial stays negative. In Bernstein's form on an interval it lies in the convex
// hull of its coefficients: where the hull crosses zero is a bound on the first zero, and where the
// coefficients increase there is no more than one.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace vcrit::simulation {

inline constexpr std::size_t degree = 5;

/// Derivatives c_0..c_5 at x = 0 of sum_k c_k x^k/k!.
using Derivatives = std::array<double, degree + 1>;

class Bernstein {
 public:
  /// On [0, h], which becomes [0, 1].
  Bernstein(const Derivatives& c, double h) {
    double power = 1;
    for (std::size_t k = 0; k <= degree; ++k) {
      a_[k] = c[k] * power;
      power *= h / static_cast<double>(k + 1);
    }
  }

  /// The share of the interval from 0 on, x = 0 apart, over which the polynomial is negative; short
  /// of its first zero by no more than rounding.
  double negative_share() {
    divide_by_zeros();
    if (!(a_[0] < 0)) return 0;
    to_bernstein();
    double from = 0;
    for (int i = 0; i < 100; ++i) {
      const double step = hull_crossing();
      if (step >= 1) return 1;
      if (increasing()) return zero(from, from + (1 - from) * polygon_crossing());
      from += (1 - from) * step;
      if (step < 1e-9) break;
      cut(step);
    }
    return from;
  }

 private:
  using Coefficients = std::array<double, degree + 1>;

  // Zeros at x = 0.
  void divide_by_zeros() {
    while (a_[0] == 0 && n_ > 1) {
      std::rotate(a_.begin(), a_.begin() + 1, a_.end());
      a_[n_--] = 0;
    }
  }

  // b_i = sum_k C(i,k)/C(n,k) a_k
  void to_bernstein() {
    for (std::size_t i = 0; i <= n_; ++i)
      for (std::size_t k = 0; k <= i; ++k) b_[i] += weight[n_][i][k] * a_[k];
  }

  // Where the hull of the points (i/n, b_i) reaches 0 at the earliest: along its steepest line from
  // the first of them.
  double hull_crossing() const {
    double steepest = -b_[0];
    for (std::size_t i = 1; i <= n_; ++i)
      steepest = std::max(steepest, (b_[i] - b_[0]) * stretch[n_][i]);
    return -b_[0] / steepest;
  }

  // Where the line through the points does: about where the polynomial does.
  double polygon_crossing() const {
    std::size_t i = 1;
    while (i < n_ && b_[i] < 0) ++i;
    return (static_cast<double>(i) - b_[i] / (b_[i] - b_[i - 1])) / static_cast<double>(n_);
  }

  bool increasing() const {
    bool result = true;
    for (std::size_t i = 0; i < n_; ++i) result = result && b_[i] < b_[i + 1];
    return result;
  }

  // De Casteljau: the same polynomial on [share, 1].
  void cut(double share) {
    for (std::size_t level = n_; level > 0; --level)
      for (std::size_t i = 0; i < level; ++i) b_[i] += share * (b_[i + 1] - b_[i]);
  }

  // The only zero between low and 1, by Newton's method in a bracket.
  double zero(double low, double x) const {
    double high = 1;
    for (int i = 0; i < 60; ++i) {
      double value = a_[n_], slope = 0;
      for (std::size_t k = n_; k-- > 0;) {
        slope = slope * x + value;
        value = value * x + a_[k];
      }
      (value < 0 ? low : high) = x;
      double next = x - value / slope;
      if (!(next > low && next < high)) next = 0.5 * (low + high);
      const bool near = std::abs(next - x) <= 1e-6 * x;  // the error left is the square
      x = next;
      if (near) break;
    }
    return x;
  }

  // C(i,k)/C(n,k)
  static constexpr auto weight = [] {
    std::array<std::array<Coefficients, degree + 1>, degree + 1> table{};
    for (std::size_t n = 0; n <= degree; ++n)
      for (std::size_t i = 0; i <= n; ++i) {
        table[n][i][0] = 1;
        for (std::size_t k = 1; k <= i; ++k)
          table[n][i][k] =
              table[n][i][k - 1] * static_cast<double>(i + 1 - k) / static_cast<double>(n + 1 - k);
      }
    return table;
  }();

  // n/i
  static constexpr auto stretch = [] {
    std::array<Coefficients, degree + 1> table{};
    for (std::size_t n = 1; n <= degree; ++n)
      for (std::size_t i = 1; i <= n; ++i)
        table[n][i] = static_cast<double>(n) / static_cast<double>(i);
    return table;
  }();

  std::size_t n_ = degree;
  Coefficients a_{}, b_{};
};

}  // namespace vcrit::simulation
