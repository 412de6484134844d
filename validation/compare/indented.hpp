// Of a scene with an indenter: friction against amplitude and shape, the state of the contact over
// width and period, and the limits that must hold.
#pragma once

#include "answers/critical_onset.hpp"
#include "compare/scene_report.hpp"
#include "compare/witnesses.hpp"

namespace vcrit::validation {

/// Adds `indented` and its comparisons. onset: the scene's. Throws ModelError where cells have no
/// steady state.
void examine_indenter(SceneReport& report, const CriticalOnset& onset, const Witnesses& witnesses);

}  // namespace vcrit::validation
