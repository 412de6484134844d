#include "scene/stiffness_columns.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "base/joined.hpp"
#include "base/numbers.hpp"
#include "base/units.hpp"

namespace vcrit {

namespace {

struct Known {
  std::vector<std::string> names;  // the first one is the usual one
  Dimension dimension;
};

// As instruments name them; a shear modulus (G') is no Young's modulus and has no name here.
const std::array<Known, measured_quantities>& known() {
  static const std::array<Known, measured_quantities> all{
      {{{"frequency", "freq", "f"}, Dimension::frequency},
       {{"angular_frequency", "omega"}, Dimension::angular_frequency},
       {{"storage", "storage_modulus", "storage_stiffness", "e'", "k'", "e_prime", "k_prime"},
        Dimension::stiffness},
       {{"loss", "loss_modulus", "loss_stiffness", "e''", "e\"", "k''", "k\"", "e_double_prime",
         "k_double_prime"},
        Dimension::stiffness},
       {{"tan_delta", "tan_d", "loss_factor"}, Dimension::none},
       {{"storage_error"}, Dimension::stiffness},
       {{"loss_error"}, Dimension::stiffness}}};
  return all;
}

const std::string& usual_name(std::size_t quantity) { return known()[quantity].names.front(); }

// "Storage error [N/um]" is storage_error and N/um.
struct Heading {
  std::string name, unit;
  std::string cell = {}, written = {};  ///< whole, and the name, as the file has them: E', not e'
};
Heading heading(const std::string& cell, const Place& place) {
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
  result.cell = cell;
  result.written = name;
  for (char& c : name)
    c = c == ' ' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

/// Spreadsheets of some countries write semicolons, instruments tabs.
void refuse_other_separators(const std::string& cell, const Place& place) {
  const bool tabs = cell.find('\t') != std::string::npos;
  if (tabs || cell.find(';') != std::string::npos)
    throw InputError(place,
                     tabs ? "columns separated by tabs" : fmt::format("a column \"{}\"", cell),
                     "columns separated by commas, and decimal points: 2.5, not 2,5");
}

/// "freq_hz": a column that is known, with its unit where a name ends.
std::string with_unit_in_brackets(const std::string& name) {
  const std::size_t bar = name.find_last_of('_');
  if (bar == std::string::npos) return "";
  const std::string begin = name.substr(0, bar);
  for (const Known& each : known())
    if (std::find(each.names.begin(), each.names.end(), begin) != each.names.end())
      return fmt::format("a unit stands in brackets: \"{} [{}]\"", begin, si_unit(each.dimension));
  return "";
}

/// What to do with a column that has no place here.
std::string advice_on_column(const std::string& cell, const std::string& name) {
  if (to_double(cell)) return "the first line names the columns, and numbers follow it";
  if (cell.starts_with('#')) return "leave out lines of comments: the first line names the columns";
  if (name.starts_with("g'") || name.starts_with("g_") || name.starts_with("shear"))
    return "a shear modulus G is not Young's modulus: E = 2 (1 + nu) G";
  const std::string bracketed = with_unit_in_brackets(name);
  return bracketed.empty() ? "rename the column, or leave it out" : bracketed;
}

std::optional<double> modulus_in(const std::string& unit, const Place& place) {
  try {
    return parse_quantity("1 " + unit, Dimension::modulus, place);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// Of one unit in SI units. Complaints name the heading, as the file says no "1 foo".
double of_one(const Heading& heading, Dimension dimension, const Place& place) {
  const std::string one = "1 " + heading.unit;
  try {
    return parse_quantity(one, dimension, place);
  } catch (const InputError& error) {
    std::string found = error.found();
    if (const std::string quoted = '"' + one + '"'; found.starts_with(quoted))
      found.replace(0, quoted.size(), '"' + heading.cell + '"');
    if (dimension == Dimension::frequency &&
        error.advice().find("angular_frequency") != std::string::npos)
      throw InputError(place, found, error.expected(),
                       fmt::format("name the column angular_frequency [{}]", heading.unit));
    throw InputError(place, found, error.expected(), error.advice());
  }
}

double factor(const Heading& heading, Dimension dimension, const std::optional<Punch>& punch,
              StiffnessColumns& columns, const Place& place) {
  if (heading.unit.empty()) return 1;
  const auto modulus =
      dimension == Dimension::stiffness ? modulus_in(heading.unit, place) : std::nullopt;
  if (!modulus) return of_one(heading, dimension, place);
  if (!punch)
    throw InputError(place, fmt::format("{} in {}, a modulus", heading.written, heading.unit),
                     "a stiffness, as N/um; or `punch_radius` and `poisson` of a flat punch, whose "
                     "stiffness is 2 a E/(1 - nu^2)");
  columns.moduli = true;
  return *modulus * punch->length();
}

void refuse_sets(const StiffnessColumns& columns, const Place& place) {
  std::vector<std::string> missing;
  if (!columns[frequency] && !columns[angular_frequency])
    missing.emplace_back("frequency or angular_frequency");
  if (!columns[storage]) missing.push_back(usual_name(storage));
  if (!columns[loss] && !columns[tan_delta]) missing.emplace_back("loss or tan_delta");
  if (!missing.empty())
    throw InputError(place, fmt::format("no column {}", joined(missing, ", ")), expected_columns());
  if (columns[frequency] && columns[angular_frequency])
    throw InputError(place, "frequency and angular_frequency", "one of the two");
  if (columns[loss] && columns[tan_delta])
    throw InputError(place, "loss and tan_delta", "one of the two",
                     "tan_delta is loss over storage: leave its column out");
  if (columns[storage_error].has_value() != columns[loss_error].has_value())
    throw InputError(place, "one of storage_error and loss_error", "both or none");
  if (columns[loss_error] && columns[tan_delta])
    throw InputError(place, "loss_error beside tan_delta", "the errors of storage and loss");
}

// A modulus beside a stiffness would be one of them in the wrong unit.
void refuse_mixture(const StiffnessColumns& columns, const std::vector<bool>& modulus,
                    const Place& place) {
  for (const MeasuredQuantity each : {storage, loss, storage_error, loss_error})
    if (columns.moduli && columns[each] && columns[each]->has_unit && !modulus[each])
      throw InputError(place, usual_name(each) + " as a stiffness beside a modulus",
                       "moduli or stiffnesses throughout");
  for (const MeasuredQuantity each : {storage, loss, storage_error, loss_error})
    if (columns.moduli && columns[each] && !columns[each]->has_unit)
      throw InputError(place, "no unit of " + usual_name(each), "one, as the other moduli have");
}

}  // namespace

std::string expected_columns() {
  return "the columns frequency (or angular_frequency), storage, loss (or tan_delta), and if known "
         "storage_error, loss_error, separated by commas: \"frequency [Hz],storage [N/um],loss "
         "[N/um]\"";
}

StiffnessColumns stiffness_columns_of(const CsvLines& header, const std::optional<Punch>& punch) {
  StiffnessColumns columns;
  std::vector<bool> modulus(measured_quantities, false);
  const std::vector<std::string> cells = header.cells();
  for (std::size_t i = 0; i < cells.size(); ++i) {
    refuse_other_separators(cells[i], header.place());
    const Heading found = heading(cells[i], header.place());
    const auto match = std::find_if(known().begin(), known().end(), [&](const Known& each) {
      return std::find(each.names.begin(), each.names.end(), found.name) != each.names.end();
    });
    if (match == known().end())
      throw InputError(header.place(), fmt::format("a column \"{}\"", cells[i]), expected_columns(),
                       advice_on_column(cells[i], found.name));
    const auto quantity = static_cast<std::size_t>(match - known().begin());
    auto& column = columns.of[quantity];
    if (column)
      throw InputError(header.place(), fmt::format("two columns {}", usual_name(quantity)),
                       "one of each");
    const bool had_moduli = std::exchange(columns.moduli, false);
    const double to_si = factor(found, match->dimension, punch, columns, header.place());
    modulus[quantity] = columns.moduli;
    columns.moduli = columns.moduli || had_moduli;
    column = StiffnessColumn{i, to_si, !found.unit.empty()};
  }
  refuse_sets(columns, header.place());
  refuse_mixture(columns, modulus, header.place());
  if (punch && !columns.moduli)
    throw InputError(header.place(), "no modulus, but a flat punch",
                     "storage and loss with a unit of a modulus, \"storage [MPa]\", or no "
                     "`punch_radius`");
  return columns;
}

std::optional<std::string> assumed_units(const StiffnessColumns& columns) {
  std::string list;
  for (std::size_t i = 0; i < measured_quantities; ++i)
    if (columns.of[i] && !columns.of[i]->has_unit && i != tan_delta)
      list += fmt::format("{}{} in {}", list.empty() ? "" : ", ", usual_name(i),
                          si_unit(known()[i].dimension));
  if (list.empty()) return std::nullopt;
  // Instruments write moduli: as stiffnesses 2500 of them would be very soft, in silence.
  const bool may_be_modulus = columns.of[storage] && !columns.of[storage]->has_unit;
  return "the header gives no units, so numbers count as " + list +
         "; other units stand behind a name, as in \"storage [N/um]\"" +
         (may_be_modulus ? ", and those of moduli, \"storage [MPa]\"" : "");
}

}  // namespace vcrit
