#include "fit/data.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "base/constants.hpp"
#include "base/csv.hpp"
#include "base/files.hpp"
#include "base/units.hpp"
#include "fit/rounding.hpp"

namespace vcrit::fit {

namespace {

enum MeasuredQuantity {
  frequency,
  angular_frequency,
  storage,
  loss,
  storage_error,
  loss_error,
  quantities
};

struct Known {
  const char* name;
  Dimension dimension;
};
constexpr std::array<Known, quantities> known{{{"frequency", Dimension::frequency},
                                               {"angular_frequency", Dimension::angular_frequency},
                                               {"storage", Dimension::stiffness},
                                               {"loss", Dimension::stiffness},
                                               {"storage_error", Dimension::stiffness},
                                               {"loss_error", Dimension::stiffness}}};

struct TableColumn {
  std::size_t index = 0;
  double factor = 1;  // to SI
  bool has_unit = false;
};
using TableColumns = std::array<std::optional<TableColumn>, quantities>;

std::string names() {
  std::vector<std::string> list;
  for (const Known& each : known) list.emplace_back(each.name);
  return fmt::format("{}", fmt::join(list, ", "));
}

// "Storage error [N/um]" is storage_error and N/um; quotes around the whole do no harm.
struct Heading {
  std::string name, unit;
};
Heading heading(std::string cell, const Place& place) {
  if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"')
    cell = cell.substr(1, cell.size() - 2);
  const auto open = cell.find_first_of("([");
  Heading result{cell.substr(0, open), ""};
  if (open != cell.npos) {
    const auto close = cell.find_last_of(")]");
    if (close == cell.npos || close < open || close + 1 != cell.size())
      throw InputError(place, fmt::format("\"{}\"", cell),
                       "a name and its unit: \"storage [N/um]\"");
    result.unit = cell.substr(open + 1, close - open - 1);
  }
  auto& name = result.name;
  name.erase(name.find_last_not_of(' ') + 1);
  name.erase(0, name.find_first_not_of(' '));
  for (char& c : name)
    c = c == ' ' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

double factor(const Heading& heading, Dimension dimension, const Place& place) {
  return heading.unit.empty() ? 1 : parse_quantity("1 " + heading.unit, dimension, place);
}

void refuse_sets(const TableColumns& columns, const Place& place) {
  std::vector<std::string> missing;
  if (!columns[frequency] && !columns[angular_frequency])
    missing.emplace_back("frequency or angular_frequency");
  for (const MeasuredQuantity needed : {storage, loss})
    if (!columns[needed]) missing.emplace_back(known[needed].name);
  if (!missing.empty())
    throw InputError(place, fmt::format("no column {}", fmt::join(missing, ", ")),
                     "the columns " + names());
  if (columns[frequency] && columns[angular_frequency])
    throw InputError(place, "frequency and angular_frequency", "one of the two");
  if (columns[storage_error].has_value() != columns[loss_error].has_value())
    throw InputError(place, "one of storage_error and loss_error", "both or none");
}

TableColumns columns_of(const CsvLines& header) {
  TableColumns columns;
  const std::vector<std::string> cells = header.cells();
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Heading found = heading(cells[i], header.place());
    const auto match = std::find_if(known.begin(), known.end(),
                                    [&](const Known& each) { return found.name == each.name; });
    if (match == known.end())
      throw InputError(header.place(), fmt::format("a column \"{}\"", cells[i]),
                       "the columns " + names());
    auto& column = columns[static_cast<std::size_t>(match - known.begin())];
    if (column)
      throw InputError(header.place(), fmt::format("two columns {}", match->name), "one of each");
    column = TableColumn{i, factor(found, match->dimension, header.place()), !found.unit.empty()};
  }
  refuse_sets(columns, header.place());
  return columns;
}

Row row_of(const std::vector<double>& numbers, const TableColumns& columns) {
  const auto value = [&](MeasuredQuantity quantity) {
    const auto& column = columns[quantity];
    return column ? column->factor * numbers[column->index] : 0;
  };
  return {columns[frequency] ? two_pi * value(frequency) : value(angular_frequency), value(storage),
          value(loss), value(storage_error), value(loss_error)};
}

// "the header gives no unit of frequency (taken as Hz), storage (N/m)"
std::optional<std::string> assumed_units(const TableColumns& columns) {
  std::string list;
  for (std::size_t i = 0; i < quantities; ++i)
    if (columns[i] && !columns[i]->has_unit)
      list += fmt::format("{}{} in {}", list.empty() ? "" : ", ", known[i].name,
                          si_unit(known[i].dimension));
  if (list.empty()) return std::nullopt;
  return "the header gives no units, taken were: " + list +
         "; other units stand behind a name, as in \"storage [N/um]\"";
}

void refuse_values(const Row& row, bool errors, const Place& place) {
  for (const double value : {row.omega, row.storage, row.loss, row.storage_error, row.loss_error})
    if (!std::isfinite(value))
      throw InputError(place, "a number that is infinite in SI units", "the range of doubles");
  if (!(row.omega > 0))
    throw InputError(place, fmt::format("an angular frequency of {} rad/s", row.omega),
                     "a frequency above 0");
  const auto refuse = [&](const char* name, double value, const char* expected) {
    throw InputError(place, fmt::format("{} = {} N/m", name, value), expected);
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
void refuse_frequency_order(const std::vector<Row>& rows, const Place& place) {
  if (rows.size() < 2) return;
  const double before = rows[rows.size() - 2].omega, now = rows.back().omega;
  const bool rises = rows[1].omega > rows[0].omega;
  if (now != before && (now > before) == rises) return;
  throw InputError(place, fmt::format("omega = {} rad/s after {}", now, before),
                   rises ? "frequencies that go on rising" : "frequencies that go on falling");
}

void note_below_zero(Data& data, const Place& place) {
  const Row& row = data.rows.back();
  const auto note = [&](const char* name, double value) {
    if (value < 0)
      data.notes.push_back(fmt::format(
          "{}: {} = {:.4g} N/m is below 0 ({:.2g} % of |K|): taken for noise, and fitted as it is",
          to_text(place), name, value, 100 * std::abs(value) / std::hypot(row.storage, row.loss)));
  };
  note("storage", row.storage);
  note("loss", row.loss);
}

void note_steps(Data& data, const std::vector<double>& steps, double unit, double Row::*step) {
  for (std::size_t i = 0; i < steps.size(); ++i) data.rows[i].*step = unit * steps[i];
}

std::string rows_found(std::size_t rows) {
  if (rows == 0) return "no row of numbers";
  return rows == 1 ? "one row of numbers" : fmt::format("{} rows of numbers", rows);
}

}  // namespace

Data parse_data(const std::string& text, const std::string& file) {
  CsvLines lines(text, file);
  if (!lines.next()) throw InputError({file}, "an empty table", "a header with " + names());
  const TableColumns columns = columns_of(lines);
  const std::size_t count = lines.cells().size();
  std::vector<std::string> storages, losses;
  Data data{file, {}, columns[storage_error].has_value(), {}};
  if (const auto note = assumed_units(columns)) data.notes.push_back(*note);
  while (lines.next()) {
    data.rows.push_back(
        row_of(lines.numbers(count, fmt::format("{} numbers, as the header has", count)), columns));
    data.rows.back().line = lines.place().line;
    storages.push_back(lines.cells()[columns[storage]->index]);
    losses.push_back(lines.cells()[columns[loss]->index]);
    refuse_values(data.rows.back(), data.has_errors, lines.place());
    note_below_zero(data, lines.place());
    refuse_frequency_order(data.rows, lines.place());
  }
  if (data.rows.size() < least_rows)
    throw InputError(lines.place(), rows_found(data.rows.size()),
                     fmt::format("at least {} rows, one frequency each: any two are met exactly, "
                                 "so that nothing would tell noise from material",
                                 least_rows));
  note_steps(data, rounding_steps(storages), columns[storage]->factor, &Row::storage_step);
  note_steps(data, rounding_steps(losses), columns[loss]->factor, &Row::loss_step);
  if (data.rows[1].omega < data.rows[0].omega) std::reverse(data.rows.begin(), data.rows.end());
  return data;
}

Data read_data(const std::string& file) { return parse_data(read_file(file), file); }

}  // namespace vcrit::fit
