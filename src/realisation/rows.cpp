#include "realisation/rows.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "base/errors.hpp"

namespace vcrit::realisation {

namespace {

using Eigen::Index;

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void set_units(Rows& rows, const Receptance& table) {
  std::vector<double> sizes;
  for (const auto& row : table.rows)
    if (const double size = std::hypot(row.re, row.im); size > 0 && std::isfinite(size))
      sizes.push_back(size);
  if (sizes.empty())
    throw InputError({table.file, 0}, "no response in any row", "a receptance that is not 0");
  rows.value_unit = median_of(sizes);
  rows.frequency_unit = table.rows.back().omega;
}

/// |change of R|/|R| from one row to the next, and a share of its mean, so that rows where nothing
/// happens are left as well.
std::vector<double> arc_length(const Rows& rows) {
  std::vector<double> length{0};
  for (Index i = 1; i < rows.size(); ++i)
    length.push_back(length.back() +
                     std::min(1.0, std::abs(rows.value[i] - rows.value[i - 1]) *
                                       std::max(rows.weight[i], rows.weight[i - 1])));
  const double even = std::max(length.back(), 1e-300) / static_cast<double>(rows.size());
  for (std::size_t i = 0; i < length.size(); ++i) length[i] += even * static_cast<double>(i);
  return length;
}

}  // namespace

double Rows::first() const {
  const auto positive = std::find_if(omega.begin(), omega.end(), [](double w) { return w > 0; });
  return *positive;
}

Rows rows_of(const Receptance& table) {
  Rows rows;
  set_units(rows, table);
  const auto count = static_cast<Index>(table.rows.size());
  rows.omega.resize(count), rows.value.resize(count), rows.weight.resize(count);
  for (Index i = 0; i < count; ++i) {
    const auto& row = table.rows[static_cast<std::size_t>(i)];
    rows.omega[i] = row.omega / rows.frequency_unit;
    rows.value[i] = std::complex(row.re / rows.value_unit, row.im / rows.value_unit);
    const double size = std::abs(rows.value[i]);
    // A row of value 0 has no relative error, so it gets no weight.
    rows.weight[i] = size > 0 && std::isfinite(1 / size) ? 1 / size : 0;
  }
  return rows;
}

Rows chosen(const Rows& rows, const std::vector<Index>& places) {
  Rows some;
  some.frequency_unit = rows.frequency_unit;
  some.value_unit = rows.value_unit;
  some.omega = rows.omega(places);
  some.value = rows.value(places);
  some.weight = rows.weight(places);
  return some;
}

Rows thinned(const Rows& rows, Index most) {
  if (rows.size() <= most) return rows;
  const std::vector<double> length = arc_length(rows);
  std::vector<Index> places;
  for (Index i = 0; i < rows.size(); ++i) {
    const double due =
        length.back() * static_cast<double>(places.size()) / static_cast<double>(most - 1);
    if (length[static_cast<std::size_t>(i)] >= due || i + 1 == rows.size()) places.push_back(i);
  }
  return chosen(rows, places);
}

}  // namespace vcrit::realisation
