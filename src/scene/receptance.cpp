#include "scene/receptance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "base/files.hpp"
#include "base/numbers.hpp"

namespace vcrit {

namespace {

constexpr const char* header = "omega,Re,Im";

/// The next line without what Windows leaves at its end; nothing but blanks counts as no line.
bool next_line(std::istream& in, std::string& line, Place& place) {
  while (std::getline(in, line)) {
    ++place.line;
    line.erase(line.find_last_not_of(" \t\r") + 1);
    if (!line.empty()) return true;
  }
  return false;
}

std::string without_blanks(std::string text) {
  std::erase_if(text, [](char c) { return c == ' ' || c == '\t'; });
  return text;
}

Receptance::Row row_of(const std::string& line, const Place& place) {
  std::istringstream cells(without_blanks(line));
  std::array<double, 3> numbers{};
  std::string cell;
  std::size_t count = 0;
  for (; std::getline(cells, cell, ','); ++count) {
    const auto number = to_double(cell);
    if (!number || !std::isfinite(*number))
      throw InputError(place, fmt::format("\"{}\"", cell), "a finite number");
    if (count < numbers.size()) numbers.at(count) = *number;
  }
  if (count != numbers.size() || line.back() == ',')
    throw InputError(place, fmt::format("\"{}\"", line), "three numbers: omega, Re, Im");
  return {numbers[0], numbers[1], numbers[2]};
}

void refuse_order(const Receptance& receptance, const Receptance::Row& row, const Place& place) {
  if (row.omega < 0)
    throw InputError(place, fmt::format("omega = {}", row.omega), "an omega of at least 0");
  if (!receptance.rows.empty() && !(row.omega > receptance.rows.back().omega))
    throw InputError(place,
                     fmt::format("omega = {} after {}", row.omega, receptance.rows.back().omega),
                     "omega increasing from row to row");
}

}  // namespace

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

Receptance read_receptance(const std::filesystem::path& file, const Place& place) {
  if (!std::filesystem::is_regular_file(file))
    throw InputError(place, fmt::format("receptance = \"{}\", which is no file", file.string()),
                     fmt::format("a table in CSV with the header {}", header));
  Receptance receptance{file.string(), {}};
  std::istringstream in(read_file(file));
  Place at{receptance.file};
  std::string line;
  const bool any = next_line(in, line, at);
  if (!any || without_blanks(line) != header)
    throw InputError(at, any ? fmt::format("\"{}\"", line) : "an empty table",
                     fmt::format("the header {}", header));
  while (next_line(in, line, at)) {
    const Receptance::Row row = row_of(line, at);
    refuse_order(receptance, row, at);
    receptance.rows.push_back(row);
  }
  if (receptance.rows.size() < 2)
    throw InputError(at, receptance.rows.empty() ? "no row of numbers" : "one row of numbers",
                     "at least two rows, to interpolate between them");
  return receptance;
}

}  // namespace vcrit
