// Between which rows of a measured receptance a frequency lies.
#include <fmt/core.h>

#include <algorithm>

#include "scene/receptance.hpp"

namespace vcrit {

Bracket bracket(const Receptance& receptance, double omega) {
  const auto& rows = receptance.rows;
  const auto above =
      std::lower_bound(rows.begin(), rows.end(), omega,
                       [](const Receptance::Row& row, double value) { return row.omega < value; });
  if (above != rows.end() && above->omega == omega) return {*above, *above};
  if (above == rows.end() || above == rows.begin())
    throw ModelError(fmt::format("omega = {} rad/s is outside the receptance in {}, {} to {} rad/s",
                                 omega, receptance.file, rows.front().omega, rows.back().omega));
  return {*(above - 1), *above};
}

}  // namespace vcrit
