// How far the paper's reduced model is from the full motion, for contacts to which it applies.
#pragma once

#include <string>

#include "scene_report.hpp"

namespace vcrit::validation::report {

/// Empty where it does not apply.
std::string reduced_section(const SceneReport& report);

}  // namespace vcrit::validation::report
