#include "scene/stiffness_data.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"
#include "base/csv.hpp"
#include "base/files.hpp"
#include "base/rounded.hpp"
#include "scene/stiffness_columns.hpp"
#include "scene/written_digits.hpp"

namespace vcrit {

namespace {

StiffnessRow stiffness_row_of(const std::vector<double>& numbers, const StiffnessColumns& columns) {
  const auto value = [&](MeasuredQuantity quantity) {
    const auto& column = columns[quantity];
    return column ? column->factor * numbers[column->index] : 0;
  };
  return {columns[frequency] ? two_pi * value(frequency) : value(angular_frequency), value(storage),
          columns[tan_delta] ? value(storage) * value(tan_delta) : value(loss),
          value(storage_error), value(loss_error)};
}

void refuse_values(const StiffnessRow& row, bool errors, const Place& place) {
  for (const double value : {row.omega, row.storage, row.loss, row.storage_error, row.loss_error})
    if (!std::isfinite(value))
      throw InputError(place, "a number that is infinite in SI units", "the range of doubles");
  if (!(row.omega > 0))
    throw InputError(place, fmt::format("a frequency of {}", rounded_frequency(row.omega)),
                     "a frequency above 0");
  const auto refuse = [&](const char* name, double value, const char* expected) {
    throw InputError(place, fmt::format("{} = {}", name, rounded(value, "N/m")), expected);
  };
  const auto far_below = [&](double value, double error) {
    return errors ? value < -errors_below_zero * error
                  : value < -noise_below_zero * std::hypot(row.storage, row.loss);
  };
  if (far_below(row.storage, row.storage_error))
    refuse("storage", row.storage, "a storage stiffness of at least 0");
  if (far_below(row.loss, row.loss_error))
    refuse("loss", row.loss, "a loss stiffness of at least 0");
  if (row.storage == 0 && row.loss == 0) refuse("storage = loss", 0, "one of them above 0");
  if (!errors) return;
  if (!(row.storage_error > 0)) refuse("storage_error", row.storage_error, "an error above 0");
  if (!(row.loss_error > 0)) refuse("loss_error", row.loss_error, "an error above 0");
}

// Rising or falling, whichever the first two rows do.
void refuse_frequency_order(const std::vector<StiffnessRow>& rows, const Place& place) {
  if (rows.size() < 2) return;
  const double before = rows[rows.size() - 2].omega, now = rows.back().omega;
  const bool rises = rows[1].omega > rows[0].omega;
  if (now != before && (now > before) == rises) return;
  if (now == before)
    throw InputError(place, rounded(now / two_pi, "Hz") + " once more", "each frequency once");
  const auto [now_words, before_words] = rounded_apart(now / two_pi, before / two_pi, "Hz");
  throw InputError(place, fmt::format("{} after {}", now_words, before_words),
                   rises ? "frequencies that go on rising" : "frequencies that go on falling");
}

void note_below_zero(StiffnessTable& data, const Place& place) {
  const StiffnessRow& row = data.rows.back();
  const auto note = [&](const char* name, double value) {
    if (value < 0)
      data.notes.push_back(fmt::format(
          "{}: {} = {} is below 0 ({:.2g} % of |K|): taken for noise, and fitted as it is",
          to_text(place), name, rounded(value, "N/m"),
          100 * std::abs(value) / std::hypot(row.storage, row.loss)));
  };
  note("storage", row.storage);
  note("loss", row.loss);
}

void note_steps(StiffnessTable& data, const std::vector<double>& steps, double unit,
                double StiffnessRow::*step) {
  for (std::size_t i = 0; i < steps.size(); ++i) data.rows[i].*step = unit * steps[i];
}

// storage times tan delta moves with either.
void note_steps_of_product(StiffnessTable& data, const std::vector<double>& steps, double unit) {
  for (std::size_t i = 0; i < steps.size(); ++i) {
    StiffnessRow& row = data.rows[i];
    row.loss_step = std::hypot(std::abs(row.storage) * unit * steps[i],
                               row.storage_step * std::abs(row.loss / row.storage));
    if (!std::isfinite(row.loss_step)) row.loss_step = 0;
  }
}

std::string rows_found(std::size_t rows) {
  if (rows == 0) return "no row of numbers";
  return rows == 1 ? "one row of numbers" : fmt::format("{} rows of numbers", rows);
}

}  // namespace

StiffnessTable parse_stiffness_table(const std::string& text, const std::string& file,
                                     const std::optional<Punch>& punch) {
  CsvLines lines(text, file);
  if (!lines.next()) throw InputError({file}, "an empty table", expected_columns());
  const StiffnessColumns columns = stiffness_columns_of(lines, punch);
  const std::size_t count = lines.cells().size();
  std::vector<std::string> storages, losses;
  StiffnessTable data{file, {}, columns[storage_error].has_value(), {}};
  if (const auto note = assumed_units(columns)) data.notes.push_back(*note);
  if (columns.moduli)
    data.notes.push_back(
        fmt::format("moduli, times {}: below a flat punch of radius {} with nu = {:.6g} the "
                    "stiffness is 2 a E/(1 - nu^2)",
                    rounded(punch->length(), "m"), rounded(punch->radius, "m"), punch->poisson));
  while (lines.next()) {
    data.rows.push_back(stiffness_row_of(
        lines.numbers(count, fmt::format("{} numbers, as the header has", count)), columns));
    data.rows.back().line = lines.place().line;
    storages.push_back(lines.cells()[columns[storage]->index]);
    losses.push_back(lines.cells()[columns[columns[tan_delta] ? tan_delta : loss]->index]);
    refuse_values(data.rows.back(), data.has_errors, lines.place());
    note_below_zero(data, lines.place());
    refuse_frequency_order(data.rows, lines.place());
  }
  if (data.rows.size() < least_rows)
    throw InputError(lines.place(), rows_found(data.rows.size()),
                     fmt::format("at least {} rows, one frequency each: any two are met exactly, "
                                 "so that nothing would tell noise from material",
                                 least_rows));
  note_steps(data, rounding_steps(storages), columns[storage]->factor, &StiffnessRow::storage_step);
  if (columns[tan_delta])
    note_steps_of_product(data, rounding_steps(losses), columns[tan_delta]->factor);
  else
    note_steps(data, rounding_steps(losses), columns[loss]->factor, &StiffnessRow::loss_step);
  if (data.rows[1].omega < data.rows[0].omega) std::reverse(data.rows.begin(), data.rows.end());
  return data;
}

StiffnessTable read_stiffness_table(const std::string& file, const std::optional<Punch>& punch) {
  return parse_stiffness_table(read_file(file), file, punch);
}

}  // namespace vcrit
