// The punch below which a table of moduli was measured, from what users write.
#include <fmt/core.h>

#include <cmath>

#include "base/units.hpp"
#include "scene/stiffness_data.hpp"

namespace vcrit {

std::optional<Punch> punch_of(const std::string& radius, const std::string& poisson) {
  if (radius.empty()) return std::nullopt;
  const Place of_radius = argument("punch_radius"), of_poisson = argument("poisson");
  if (poisson.empty())
    throw InputError(of_radius, "no Poisson's ratio beside it",
                     "`poisson` as well, as the stiffness is 2 a E/(1 - nu^2)");
  const Punch punch{parse_quantity(radius, Dimension::length, of_radius),
                    parse_quantity(poisson, Dimension::none, of_poisson)};
  if (!(punch.radius > 0 && std::isfinite(punch.radius)))
    throw InputError(of_radius, fmt::format("\"{}\"", radius), "a length above 0");
  if (!(punch.poisson > -1 && punch.poisson <= 0.5))
    throw InputError(of_poisson, fmt::format("\"{}\"", poisson), "a number above -1, at most 0.5");
  return punch;
}

}  // namespace vcrit
