#include "scene/range.hpp"

#include <fmt/core.h>

#include <cmath>

#include "base/constants.hpp"

namespace vcrit {

const Range nonnegative{[](double v) { return std::isfinite(v) && v >= 0; },
                        "a finite value of at least 0"};
const Range positive{[](double v) { return std::isfinite(v) && v > 0; }, "a finite value above 0"};
const Range poisson_range{[](double v) { return v > -1 && v <= 0.5; },
                          "a Poisson's ratio above -1, up to 0.5"};
const Range frequency_range{[](double v) { return v > 0 && std::isfinite(two_pi * v); },
                            "a finite value above 0, and 2 pi f within the range of doubles"};
const Range slope_range{[](double v) { return v > 0 && v < pi / 2; },
                        "an angle between 0 and 90 deg"};

double checked(const TypedNumber& number, const Range& range, const std::string& name,
               const Place& place) {
  if (range.holds(number.value)) return number.value;
  const std::string typed = number.text.empty() ? fmt::format("{}", number.value) : number.text;
  throw InputError(place, fmt::format("{} = {}", name, typed), range.expected);
}

double checked(double value, const Range& range, const std::string& name, const Place& place) {
  return checked(TypedNumber{value}, range, name, place);
}

}  // namespace vcrit
