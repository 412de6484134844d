// Numbers for people: few digits, an SI prefix, a unit. A number is rounded where it is shown and
// nowhere else.
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "base/units.hpp"

namespace vcrit {

/// Of numbers for people; with all_digits a number reads back to the same double.
inline constexpr int few_digits = 4, all_digits = 17;

/// "4.095 mm/s", "8 N/µm", "0.1 µm", "5 g": significant digits without zeros at the end. Without a
/// prefix where none is usual ("rad/s", "", "1"); 0 is "0 m", infinite numbers are "∞", and what is
/// no number is "not a number". Powers of ten are shown beyond the prefixes alone: "2 × 10⁻³⁰ m".
std::string rounded(double value, std::string_view unit, int digits = few_digits);
std::string rounded(double value, Dimension dimension, int digits = few_digits);

/// "20 kHz" of an angular frequency (rad/s).
std::string rounded_frequency(double omega, int digits = few_digits);

/// Of a bound, in four digits: not above the value (down) or not below it (up), but for the
/// rounding of doubles. "below 0.3968 µm" of 0.39686 µm.
std::string rounded_down(double value, std::string_view unit);
std::string rounded_up(double value, std::string_view unit);

/// Both with as many digits, four or more, as tell them apart.
std::pair<std::string, std::string> rounded_apart(double a, double b, std::string_view unit);

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
