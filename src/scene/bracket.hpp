// Between which rows of a table over omega an angular frequency lies.
#pragma once

#include <algorithm>
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

}  // namespace vcrit
