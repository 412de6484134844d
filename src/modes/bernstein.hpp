// How long a polynomial stays negative. In Bernstein's form on an interval it lies in the convex
// hull of its coefficients: where the hull crosses zero is a bound on the first zero, and where the
// coefficients increase there is no more than one.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace vcrit::simulation {

/// sum_k a_k x^k, k = 0..n, on [0, 1].
template <std::size_t n>
class Bernstein {
 public:
  explicit Bernstein(const double* a) {
    std::copy_n(a, n + 1, a_.begin());
    for (std::size_t i = 0; i <= n; ++i)
      for (std::size_t k = 0; k <= i; ++k) b_[i] += weight[i][k] * a_[k];
  }

  /// The share of the interval from 0 on over which the polynomial is negative; short of its first
  /// zero by no more than rounding.
  double negative_share() {
    if (!(b_[0] < 0)) return 0;
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
  using Coefficients = std::array<double, n + 1>;

  // Where the hull of the points (i/n, b_i) reaches 0 at the earliest: along its steepest line from
  // the first of them.
  double hull_crossing() const {
    double steepest = -b_[0];
    for (std::size_t i = 1; i <= n; ++i)
      steepest = std::max(steepest, (b_[i] - b_[0]) * (double(n) / double(i)));
    return -b_[0] / steepest;
  }

  // Where the line through the points does: about where the polynomial does.
  double polygon_crossing() const {
    std::size_t i = 1;
    while (i < n && b_[i] < 0) ++i;
    return (double(i) - b_[i] / (b_[i] - b_[i - 1])) / n;
  }

  bool increasing() const {
    bool result = true;
    for (std::size_t i = 0; i < n; ++i) result = result && b_[i] < b_[i + 1];
    return result;
  }

  // De Casteljau: the same polynomial on [share, 1]. From the last coefficient to the first, each
  // through all levels: level by level, g++ joins neighbours in pairs that overlap those written
  // just before, and waits for memory at each.
  void cut(double share) {
    Coefficients after{b_[n]};
    for (std::size_t i = n; i-- > 0;) {
      double value = b_[i];
      for (std::size_t level = 0; level < n - i; ++level) {
        const double next = value + share * (after[level] - value);
        after[level] = std::exchange(value, next);
      }
      b_[i] = after[n - i] = value;
    }
  }

  // The only zero between low and 1, by Newton's method in a bracket.
  double zero(double low, double x) const {
    double high = 1;
    for (int i = 0; i < 60; ++i) {
      double value = a_[n], slope = 0;
      for (std::size_t k = n; k-- > 0;) {
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

  // b_i = sum_k C(i,k)/C(n,k) a_k
  static constexpr auto weight = [] {
    std::array<Coefficients, n + 1> table{};
    for (std::size_t i = 0; i <= n; ++i) {
      table[i][0] = 1;
      for (std::size_t k = 1; k <= i; ++k)
        table[i][k] = table[i][k - 1] * double(i + 1 - k) / double(n + 1 - k);
    }
    return table;
  }();

  Coefficients a_{}, b_{};
};

inline constexpr std::size_t degree = 5;  // of the polynomials below: c_0..c_5

/// Derivatives c_0..c_5 at x = 0 of sum_k c_k x^k/k!.
using Derivatives = std::array<double, degree + 1>;

/// How long that polynomial is negative, from 0 on and at most until h; it may leave 0 downwards,
/// with a slope or, where c_0 = c_1 = 0, without.
inline double negative_duration(const Derivatives& c, double h) {
  Derivatives a{};
  double power = 1;
  for (std::size_t k = 0; k <= degree; ++k) {
    a[k] = c[k] * power;
    power *= h * (1.0 / double(k + 1));
  }
  if (a[0] != 0) return h * Bernstein<degree>(a.data()).negative_share();
  if (a[1] != 0) return h * Bernstein<degree - 1>(a.data() + 1).negative_share();
  return h * Bernstein<degree - 2>(a.data() + 2).negative_share();
}

}  // namespace vcrit::simulation
