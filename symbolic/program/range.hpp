// How large numbers of a Program can become, as powers of two.
#pragma once

#include <algorithm>

namespace vcrit::symbolic {

struct ExponentRange {
  double low = 0, high = 0;  ///< log2 of the absolute value
};

inline ExponentRange operator+(ExponentRange a, ExponentRange b) {
  return {a.low + b.low, a.high + b.high};
}
inline ExponentRange operator-(ExponentRange a, ExponentRange b) {
  return {a.low - b.high, a.high - b.low};
}
inline ExponentRange twice(ExponentRange a) { return a + a; }
/// Both bounds hold.
inline ExponentRange both(ExponentRange a, ExponentRange b) {
  return {std::max(a.low, b.low), std::min(a.high, b.high)};
}

/// Whether elements may be 0 and all the same in range. Where not, ranges are those of numbers that
/// are not 0, and zeros are left to numbers with exponents of their own.
enum class Zeros { out_of_range, in_range };

/// Of a sum that does not cancel: at least its larger term, which with zeros may be either.
inline ExponentRange sum_range(ExponentRange a, ExponentRange b, Zeros zeros) {
  const double low = zeros == Zeros::in_range ? std::min(a.low, b.low) : std::max(a.low, b.low);
  return {low, std::max(a.high, b.high) + 1};
}
/// Of a number for which 1 stands in where it is 0.
inline ExponentRange with_one(ExponentRange a, Zeros zeros) {
  if (zeros == Zeros::out_of_range) return a;
  return {std::min(a.low, 0.0), std::max(a.high, 0.0)};
}
/// Of Q = T/K, known to lie in `q`, too; where K is 0 the quotient says nothing.
inline ExponentRange quotient_range(ExponentRange t, ExponentRange k, ExponentRange q,
                                    Zeros zeros) {
  return zeros == Zeros::in_range ? q : both(t - k, q);
}

/// Twice the digits of a double, and some: a difference that is not 0 is not smaller, relatively.
constexpr double cancellation = 110;

/// No number of a program may leave this: high enough above the subnormals that the low parts of
/// products with twice the digits are normal numbers, too.
constexpr double largest_exponent = 900;
inline bool fits(ExponentRange a) { return a.low > -largest_exponent && a.high < largest_exponent; }

}  // namespace vcrit::symbolic
