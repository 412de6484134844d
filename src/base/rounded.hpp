// Numbers for people: few digits, an SI prefix, a unit. A number is rounded where it is shown and
// nowhere else.
#pragma once

#include <string>
#include <string_view>

#include "base/units.hpp"

namespace vcrit {

/// Of numbers for people; with all_digits a number reads back to the same double.
inline constexpr int few_digits = 4, all_digits = 17;

/// "4.095 mm/s", "8 N/µm", "0.1 µm", "5 g": significant digits without zeros at the end. Without a
/// prefix where none is usual ("rad/s", "", "1"); 0 is "0 m", infinite numbers are "∞", and what is
/// no number is "not a number". Powers of ten are shown beyond the prefixes alone: "2 × 10⁻³⁰ m".
std::string rounded(double value, std::string_view unit, int digits = few_digits);
std::string rounded(double value, Dimension dimension, int digits = few_digits);

/// A share as "25 %": whole per cent, rounded down, and one digit below 1 %.
std::string whole_percent(double share);

/// "10⁻⁵"
std::string power_of_ten(int exponent);

/// What to multiply SI numbers with so that they read well, and the unit they then have.
struct UnitScale {
  double factor = 1;
  std::string unit;
};

/// For numbers up to `largest` in absolute value, as `rounded` chooses it for that one.
UnitScale scale_for(double largest, std::string_view unit);

}  // namespace vcrit
