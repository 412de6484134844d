#include "simulators/cases.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <fstream>
#include <map>

#include "base/constants.hpp"
#include "base/errors.hpp"

namespace vcrit::simulators {

namespace {

using Cells = std::map<std::string, std::string>;

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char c : line) {
    if (c == ',')
      cells.emplace_back();
    else if (c != '\r')
      cells.back() += c;
  }
  return cells;
}

double number_of(const Cells& cells, const char* key) { return std::stod(cells.at(key)); }

std::string name_of(const Cells& cells) {
  std::string name = cells.at("problem");
  if (!cells.at("k1").empty())
    name += ", tau " + cells.at("tau_periods");
  else if (cells.at("k_d") != "inf")
    name += ", k_d " + cells.at("k_d");
  else
    name += ", delta " + cells.at("c");
  return name + ", " + cells.at("velocity_ratio") + " v*";
}

simulation::System system_of(const Cells& cells) {
  simulation::System system;
  system.contact = {number_of(cells, "k0"), number_of(cells, "c"), {}};
  if (!cells.at("k1").empty())
    system.contact.branches = {{number_of(cells, "k1"), number_of(cells, "tau_periods") * two_pi}};
  if (cells.at("k_d") != "inf") {
    system.drive = Relaxation{number_of(cells, "k_d"), number_of(cells, "c_d"), {}};
    system.mass = number_of(cells, "m");
  }
  system.omega = 1;
  system.friction = number_of(cells, "mu0");
  system.mean_normal_force = 1;
  system.normal_force_amplitude = number_of(cells, "F_n_amplitude");
  return system;
}

Case case_of(const Cells& cells) {
  Case row;
  row.problem = cells.at("problem");
  row.name = name_of(cells);
  row.system = system_of(cells);
  row.threshold = number_of(cells, "v_star");
  row.velocity = number_of(cells, "velocity");
  row.friction_ratio = number_of(cells, "friction_ratio");
  row.events = std::stoul(cells.at("events_per_cycle"));
  row.grazing = number_of(cells, "velocity_ratio") > 0.9;
  if (!cells.at("k1").empty()) {
    const double periods = number_of(cells, "tau_periods");
    row.stiff = periods <= 1e-3 || periods >= 1e3;
  }
  return row;
}

}  // namespace

std::vector<Case> read_cases(const std::filesystem::path& table) {
  std::ifstream file(table);
  std::string line;
  if (!std::getline(file, line))
    throw InputError({table.string()}, "no such table", "the reference table of steady states");
  const std::vector<std::string> header = split(line);
  std::vector<Case> cases;
  while (std::getline(file, line)) {
    const std::vector<std::string> fields = split(line);
    Cells cells;
    for (std::size_t i = 0; i < header.size() && i < fields.size(); ++i)
      cells[header[i]] = fields[i];
    try {
      cases.push_back(case_of(cells));
    } catch (const std::logic_error&) {
      throw InputError({table.string()}, fmt::format("\"{}\"", line), "a row of steady motion");
    }
  }
  return cases;
}

std::vector<std::string> problems(const std::vector<Case>& cases) {
  std::vector<std::string> names;
  for (const Case& row : cases)
    if (std::find(names.begin(), names.end(), row.problem) == names.end())
      names.push_back(row.problem);
  return names;
}

}  // namespace vcrit::simulators
