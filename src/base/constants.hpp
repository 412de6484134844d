// Numbers that many rooms use, under one name each.
#pragma once

#include <limits>
#include <numbers>

namespace vcrit {

inline constexpr double pi = std::numbers::pi;
inline constexpr double two_pi = 2 * pi;  ///< a full turn; a period in units of 1/omega
inline constexpr double infinity = std::numeric_limits<double>::infinity();
/// From 1 to the next double: twice what one rounding may change, relative to the value.
inline constexpr double epsilon = std::numeric_limits<double>::epsilon();

}  // namespace vcrit
