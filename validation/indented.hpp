// Of a scene with an indenter: friction against amplitude and shape, the state of the contact over
// width and period, and the limits that must hold.
#pragma once

#include "scene_report.hpp"

namespace vcrit::validation {

/// Adds `indented` and its comparisons. Throws ModelError where cells have no steady state.
void examine_indenter(SceneReport& report);

}  // namespace vcrit::validation
