// Sliders for the scene's parameters, and what v* and friction become; explorer.js moves it.
#pragma once

#include <string>
#include <vector>

#include "compare/scene_report.hpp"
#include "record/fields.hpp"

namespace vcrit::validation::report {

/// For the page's template; null for a scene without an explorer.
record::Json explorer_record(const SceneReport& report);

/// What must run on the page, in this order; empty for a scene without an explorer.
std::vector<std::string> explorer_scripts(const SceneReport& report);

}  // namespace vcrit::validation::report
