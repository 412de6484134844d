// How large numbers of a Program can become, as powers of two.
#pragma once

#include <algorithm>

namespace vcrit::symbolic {

struct Range {
  double low = 0, high = 0;  ///< log2 of the absolute value
};

inline Range operator+(Range a, Range b) { return {a.low + b.low, a.high + b.high}; }
inline Range operator-(Range a, Range b) { return {a.low - b.high, a.high - b.low}; }
inline Range twice(Range a) { return a + a; }
/// Both bounds hold.
inline Range both(Range a, Range b) { return {std::max(a.low, b.low), std::min(a.high, b.high)}; }

/// No number of a program may leave this: high enough above the subnormals that the low parts of
/// products with twice the digits are normal numbers, too.
constexpr double largest_exponent = 900;
inline bool fits(Range a) { return a.low > -largest_exponent && a.high < largest_exponent; }

}  // namespace vcrit::symbolic
