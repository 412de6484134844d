// Between which rows of a measured receptance a frequency lies, and words where it is outside.
#include "scene/bracket.hpp"

#include <fmt/core.h>

#include "base/constants.hpp"
#include "base/rounded.hpp"
#include "scene/receptance.hpp"

namespace vcrit {

Bracket bracket(const Receptance& receptance, double omega) {
  const auto& rows = receptance.rows;
  if (rows.empty())
    throw InputError(argument("receptance"), "a table without rows", "two rows or more");
  const auto [below, above] = rows_around(rows, omega);
  if (below == nullptr)
    throw ModelError(outside_words(omega, "the receptance in " + receptance.file,
                                   rows.front().omega, rows.back().omega));
  return {*below, *above};
}

std::string outside_words(double omega, const std::string& table, double first, double last) {
  const bool below = omega < first;
  const auto [here, end] = rounded_apart(omega / two_pi, (below ? first : last) / two_pi, "Hz");
  return fmt::format("{} is outside {}, {} to {}", here, table,
                     below ? end : rounded_frequency(first), below ? rounded_frequency(last) : end);
}

}  // namespace vcrit
