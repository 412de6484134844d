// The rows of tests/data/stickslip_reference.csv as systems. Units: omega = 1, <F_n> = 1.
#pragma once

#include <fstream>
#include <map>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "simulation/system/system.hpp"

namespace vcrit::reference {

struct Row {
  std::string name;
  simulation::System system;
  double threshold = 0, velocity = 0, friction_ratio = 0;
  std::size_t events = 0;
};

inline simulation::System system_of_row(std::map<std::string, std::string>& cell) {
  const auto number = [&](const char* key) { return std::stod(cell.at(key)); };
  simulation::System system;
  system.contact = {number("k0"), number("c"), {}};
  if (!cell["k1"].empty())
    system.contact.branches = {{number("k1"), number("tau_periods") * 2 * std::numbers::pi}};
  if (cell["k_d"] != "inf") {
    system.drive = Relaxation{number("k_d"), number("c_d"), {}};
    system.mass = number("m");
  }
  system.omega = 1;
  system.friction = number("mu0");
  system.mean_normal_force = 1;
  system.normal_force_amplitude = number("F_n_amplitude");
  return system;
}

inline std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char c : line) {
    if (c == ',')
      cells.emplace_back();
    else if (c != '\r')
      cells.back() += c;
  }
  return cells;
}

inline std::vector<Row> reference_rows() {
  std::ifstream file(VCRIT_TEST_DATA "/stickslip_reference.csv");
  if (!file) throw std::runtime_error("no stickslip_reference.csv");
  std::string line;
  std::getline(file, line);
  const std::vector<std::string> header = cells_of(line);
  std::vector<Row> rows;
  while (std::getline(file, line)) {
    const std::vector<std::string> cells = cells_of(line);
    std::map<std::string, std::string> cell;
    for (std::size_t i = 0; i < header.size(); ++i) cell[header[i]] = cells.at(i);
    rows.push_back({line, system_of_row(cell), std::stod(cell.at("v_star")),
                    std::stod(cell.at("velocity")), std::stod(cell.at("friction_ratio")),
                    static_cast<std::size_t>(std::stoul(cell.at("events_per_cycle")))});
  }
  return rows;
}

}  // namespace vcrit::reference
