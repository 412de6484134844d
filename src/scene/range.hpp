// What values a quantity of a scene may have.
#pragma once

#include <string>

#include "base/errors.hpp"
#include "base/units.hpp"

namespace vcrit {

/// What a quantity's value must satisfy.
struct Range {
  bool (*holds)(double);
  const char* expected;
};
extern const Range nonnegative, positive, poisson_range, slope_range;
extern const Range frequency_range;  ///< cycles a second, whose 2 pi f is a double, too

/// The value. Throws InputError, with `name`, where it is out of range.
double checked(double value, const Range& range, const std::string& name, const Place& place);
/// The same of a number that was typed, which the message has as it was.
double checked(const TypedNumber& number, const Range& range, const std::string& name,
               const Place& place);

}  // namespace vcrit
