// One scene, every way to its critical velocity against one reference: the certified value of
// Eq. 24 (correctly rounded) against plain doubles, the derived formula with 50 digits, the
// generated evaluator, and the simulation, which knows nothing of Eq. 24.
#pragma once

#include <functional>
#include <string>

#include "scene_report.hpp"

namespace vcrit::validation {

/// Told what is being done now, in a few words.
using Progress = std::function<void(const std::string& step)>;

/// Throws InputError for missing values, ModelError where Eq. 24 is 0/0. A scene that is not
/// admissible is not simulated; its formulas are compared all the same.
SceneReport agree(const Scene& scene, const Progress& progress);

}  // namespace vcrit::validation
