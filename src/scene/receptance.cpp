#include "scene/receptance.hpp"

#include <fmt/core.h>

#include <filesystem>

#include "base/csv.hpp"
#include "base/files.hpp"

namespace vcrit {

namespace {

constexpr const char* receptance_header = "omega,Re,Im";

void refuse_receptance_order(const Receptance& receptance, const Receptance::Row& row,
                             const Place& place) {
  if (row.omega < 0)
    throw InputError(place, fmt::format("omega = {}", row.omega), "an omega of at least 0");
  if (!receptance.rows.empty() && !(row.omega > receptance.rows.back().omega))
    throw InputError(place,
                     fmt::format("omega = {} after {}", row.omega, receptance.rows.back().omega),
                     "omega increasing from row to row");
}

}  // namespace

Receptance read_receptance(const std::string& file, const Place& place) {
  if (!std::filesystem::is_regular_file(file))
    throw InputError(place, fmt::format("receptance = \"{}\", which is no file", file),
                     fmt::format("a table in CSV with the header {}", receptance_header));
  return parse_receptance(read_file(file), file);
}

Receptance parse_receptance(const std::string& text, const std::string& file) {
  Receptance receptance{.file = file, .rows = {}};
  CsvLines lines(text, file);
  lines.take_header(receptance_header,
                    "omega in rad/s, and Re and Im of displacement over force in m/N; of an "
                    "amplitude A and a phase p they are A cos p and A sin p");
  while (lines.next()) {
    const auto numbers = lines.numbers(3, "three numbers: omega, Re, Im");
    const Receptance::Row row{numbers[0], numbers[1], numbers[2], lines.place().line};
    refuse_receptance_order(receptance, row, lines.place());
    receptance.rows.push_back(row);
  }
  if (receptance.rows.size() < 2)
    throw InputError(lines.place(),
                     receptance.rows.empty() ? "no row of numbers" : "one row of numbers",
                     "at least two rows, to interpolate between them");
  return receptance;
}

}  // namespace vcrit
