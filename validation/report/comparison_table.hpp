// What was compared with what, as a table.
#pragma once

#include <string>

#include "scene_report.hpp"

namespace vcrit::validation::report {

std::string comparison_table(const SceneReport& report);

}  // namespace vcrit::validation::report
