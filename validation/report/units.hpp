// Numbers for people: SI prefixes and a sensible number of digits.
#pragma once

#include <string>

namespace vcrit::validation::report {

/// What to multiply SI numbers with so that they read well, and the unit they then have.
struct Scale {
  double factor = 1;
  std::string unit;
};

/// For numbers up to `largest` in absolute value; `unit` takes a prefix ("m/s" -> "mm/s"). No
/// prefix for empty units, "rad/s" and for 0.
Scale scale_for(double largest, const std::string& unit);

/// "8 N/µm" reads "8 MN/m": `digits` significant digits and a prefixed unit.
std::string quantity(double value, const std::string& unit, int digits = 6);

/// A difference or a tolerance: "3.2 × 10⁻¹⁶", "0", "∞".
std::string magnitude(double value);

}  // namespace vcrit::validation::report
