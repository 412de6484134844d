// Numbers without a unit that are probably of another one: amplitude = 0.2 is 0.2 m.
#pragma once

#include <string>
#include <vector>

#include "base/complaints.hpp"
#include "base/errors.hpp"

namespace vcrit {

/// A quantity that was given as a number alone.
struct BareNumber {
  std::string key;  ///< "amplitude"
  double value = 0;
  Place place;
};

/// What to warn of in a scene that gives other quantities with their units. A scene of bare numbers
/// alone is taken at its word: it may be in units of its own, with 1 for whatever is of its size.
std::vector<Warning> suspicious_bare_numbers(const std::vector<BareNumber>& numbers);

}  // namespace vcrit
