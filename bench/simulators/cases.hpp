// The rows of the reference table (tests/data/stickslip_reference.csv) as cases: steady
// friction to 22 digits for problems P1 (Kelvin contact, rigid drive), P2 (elastic contact, nearly
// undamped drive) and P3 (Zener contact, relaxation times over 15 decades). Units: omega = 1,
// <F_n> = 1.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "simulation/system/system.hpp"

namespace vcrit::simulators {

struct Case {
  std::string problem;  ///< "P1"
  std::string name;     ///< "P3, tau 1e-6, v0 = 0.5 v*"
  simulation::System system;
  double threshold = 0;  ///< v*, as a speed of the drive
  double velocity = 0;
  double friction_ratio = 0;
  std::size_t events = 0;
  bool grazing = false;  ///< stick is short: v0 near v*
  bool stiff = false;    ///< relaxation within 1e-3 or over 1e3 periods
};

/// Throws InputError.
std::vector<Case> read_cases(const std::filesystem::path& table);

/// Of the cases, by order of appearance.
std::vector<std::string> problems(const std::vector<Case>& cases);

}  // namespace vcrit::simulators
