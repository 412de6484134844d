// Between which rows of a table over omega an angular frequency lies.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace vcrit {

/// The rows below and above, one row twice where omega (rad/s) is its own; null pointers outside
/// the table. Rows have a member omega, which increases.
template <class Row>
std::pair<const Row*, const Row*> rows_around(const std::vector<Row>& rows, double omega) {
  const auto above =
      std::lower_bound(rows.begin(), rows.end(), omega,
                       [](const Row& row, double value) { return row.omega < value; });
  if (above == rows.end()) return {nullptr, nullptr};
  if (above->omega == omega) return {&*above, &*above};
  if (above == rows.begin()) return {nullptr, nullptr};
  return {&*(above - 1), &*above};
}

/// "20 kHz is outside the receptance in drive.csv, 1 kHz to 10 kHz": `table` with its file, whose
/// rows go from omega `first` to `last`.
std::string outside_words(double omega, const std::string& table, double first, double last);

}  // namespace vcrit
