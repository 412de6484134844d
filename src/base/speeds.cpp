#include "base/speeds.hpp"

#include <cmath>

#include "base/rounded.hpp"

namespace vcrit {

void check_speed(double velocity, const Place& place) {
  if (velocity > 0 && std::isfinite(velocity)) return;
  throw InputError(place, "a speed of " + rounded(velocity, "m/s"), "a finite speed above 0");
}

void check_speed_ratio(double ratio, const Place& place, const std::string& written) {
  if (ratio > 0 && std::isfinite(ratio)) return;
  const bool as_typed = std::isfinite(ratio) && !written.empty();
  throw InputError(place, as_typed ? written : rounded(ratio, "", all_digits),
                   std::isinf(ratio) ? "a finite ratio" : "a ratio above 0");
}

}  // namespace vcrit
