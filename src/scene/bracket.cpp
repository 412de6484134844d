// Between which rows of a measured receptance a frequency lies.
#include "scene/bracket.hpp"

#include <fmt/core.h>

#include "scene/receptance.hpp"

namespace vcrit {

Bracket bracket(const Receptance& receptance, double omega) {
  const auto& rows = receptance.rows;
  if (rows.empty())
    throw InputError(argument("receptance"), "a table without rows", "two rows or more");
  const auto [below, above] = rows_around(rows, omega);
  if (below == nullptr)
    throw ModelError(fmt::format("omega = {} rad/s is outside the receptance in {}, {} to {} rad/s",
                                 omega, receptance.file, rows.front().omega, rows.back().omega));
  return {*below, *above};
}

}  // namespace vcrit
