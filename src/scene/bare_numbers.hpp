// Numbers without a unit that are probably of another one: amplitude = 0.2 is 0.2 m.
#pragma once

#include <string>
#include <vector>

#include "base/complaints.hpp"
#include "base/errors.hpp"
#include "base/units.hpp"

namespace vcrit {

/// A quantity that was given as a number alone.
struct BareNumber {
  std::string key;  ///< "amplitude"
  double value = 0;
  Place place;
  /// Where the scene gives the quantity with a unit, in which this number is nearer to it.
  std::string unit = {};
  Dimension dimension = Dimension::none;  ///< where it has that unit
};

/// "N/um" where `text`, what the scene says, has this unit and a value that the bare number `set`
/// is nearer to in this unit than in SI: 4 in place of "5 N/um". Else nothing.
std::string nearer_unit(double set, const std::string& text, Dimension dimension);

/// What to warn of in a scene that gives other quantities with their units. A scene of bare numbers
/// alone is taken at its word: it may be in units of its own, with 1 for whatever is of its size.
std::vector<Warning> suspicious_bare_numbers(const std::vector<BareNumber>& numbers);

}  // namespace vcrit
