// All that the page of one scene shows.
#pragma once

#include <optional>

#include "accuracy/data.hpp"
#include "compare/scene_report.hpp"

namespace vcrit::validation::report {

struct SceneContents {
  SceneReport report;
  std::optional<accuracy::Accuracy> accuracy;
};

}  // namespace vcrit::validation::report
