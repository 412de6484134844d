// Numbers on pages: as people read them everywhere (base/rounded.hpp), and differences.
#pragma once

#include <string>

#include "base/rounded.hpp"

namespace vcrit::validation::report {

using Scale = vcrit::UnitScale;
using vcrit::scale_for;

/// `rounded`, with more digits.
std::string quantity(double value, const std::string& unit, int digits = 6);

/// The same words, in which no line ends between a number and its unit or its power: "4.1 mm/s".
std::string unbroken(const std::string& words);

/// A regime as records call it, for people: "stick-slip, and the contact opens".
std::string motion_words(const std::string& regime);

/// A difference or a tolerance: "3.2 × 10⁻¹⁶", "0", "∞".
std::string magnitude(double value);

}  // namespace vcrit::validation::report
