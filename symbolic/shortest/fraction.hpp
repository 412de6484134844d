// Small exact fractions: the coefficients of a formula. Those that leave 64 bits are no formula for
// people, and whoever makes one falls back to another form.
#pragma once

#include <compare>
#include <cstdint>
#include <numeric>

namespace vcrit::symbolic::shortest {

/// A coefficient beyond 64 bits, or work beyond its bound.
struct TooLarge {};

struct SmallFraction {
  std::int64_t over = 1, under = 1;  ///< without a common divisor; under > 0

  bool is_zero() const { return over == 0; }
  bool is_one() const { return over == 1 && under == 1; }
  bool is_unit() const { return (over == 1 || over == -1) && under == 1; }
  bool negative() const { return over < 0; }
  friend bool operator==(const SmallFraction&, const SmallFraction&) = default;
};

inline std::int64_t times_checked(std::int64_t a, std::int64_t b) {
  std::int64_t product = 0;
  if (__builtin_mul_overflow(a, b, &product)) throw TooLarge{};
  return product;
}

inline SmallFraction reduced(std::int64_t over, std::int64_t under) {
  if (under < 0) over = -over, under = -under;
  const std::int64_t common = std::gcd(over, under);
  return common == 0 ? SmallFraction{over, under} : SmallFraction{over / common, under / common};
}

inline SmallFraction operator-(SmallFraction a) { return {-a.over, a.under}; }
inline SmallFraction operator*(SmallFraction a, SmallFraction b) {
  if (a.under == 1 && b.under == 1) return {times_checked(a.over, b.over), 1};  // nearly always
  const SmallFraction first = reduced(a.over, b.under), second = reduced(b.over, a.under);
  return {times_checked(first.over, second.over), times_checked(first.under, second.under)};
}
inline SmallFraction reciprocal(SmallFraction a) { return reduced(a.under, a.over); }
inline SmallFraction operator/(SmallFraction a, SmallFraction b) { return a * reciprocal(b); }
inline SmallFraction operator+(SmallFraction a, SmallFraction b) {
  std::int64_t sum = 0;
  if (__builtin_add_overflow(times_checked(a.over, b.under), times_checked(b.over, a.under), &sum))
    throw TooLarge{};
  return reduced(sum, times_checked(a.under, b.under));
}
inline SmallFraction absolute(SmallFraction a) { return {a.over < 0 ? -a.over : a.over, a.under}; }

}  // namespace vcrit::symbolic::shortest
