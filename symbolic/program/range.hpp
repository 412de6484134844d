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

/// Twice the digits of a double, and some: a difference that is not 0 is not smaller, relatively.
constexpr double cancellation = 110;

/// No number of a program may leave this: high enough above the subnormals that the low parts of
/// products with twice the digits are normal numbers, too.
constexpr double largest_exponent = 900;
inline bool fits(ExponentRange a) { return a.low > -largest_exponent && a.high < largest_exponent; }

}  // namespace vcrit::symbolic
