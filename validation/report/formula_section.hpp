// The derived formula with its derivation and limits, and the scene's numbers.
#pragma once

#include <string>

#include "scene_report.hpp"

namespace vcrit::validation::report {

std::string formula_section(const SceneReport& report);
std::string values_section(const SceneReport& report);

}  // namespace vcrit::validation::report
