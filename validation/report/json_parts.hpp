// What every report.json is made of. Keys: docs/report.md.
#pragma once

#include <nlohmann/json.hpp>

#include "figures/figure.hpp"
#include "report/machine_section.hpp"
#include "scene_report.hpp"

namespace vcrit::validation::report {

nlohmann::ordered_json json(const Comparison& comparison);
nlohmann::ordered_json json(const Formula& formula);
nlohmann::ordered_json json(const figures::Figure& figure);
nlohmann::ordered_json json(const Machine& machine);
nlohmann::ordered_json numbers(const std::vector<double>& values);

/// `program`, `version`, `passed`, `command`, `machine`.
nlohmann::ordered_json report_head(const Origin& origin, bool passed);

/// As the file has it.
std::string text_of(const nlohmann::ordered_json& report);

}  // namespace vcrit::validation::report
