// One scene on the page: verdict, drawing, comparisons, friction, formula, values, file; each part
// only where the scene has it.
#pragma once

#include <string>

#include "report/scene_contents.hpp"

namespace vcrit::validation::report {

/// The scene's title, or its file's name.
std::string title_of(const SceneReport& report);

/// "failed", "passed", "not-run" or "outside": how the scene is marked.
const char* state_class(const SceneReport& report);
/// "1 of 9 comparisons failed", "outside the model: not simulated", ...
std::string state_words(const SceneReport& report);
/// "v* = 3.02 mm/s"
std::string velocity_words(const SceneReport& report);

std::string scene_section(const SceneContents& contents);

}  // namespace vcrit::validation::report
