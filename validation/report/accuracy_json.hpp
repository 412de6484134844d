// A scene's accuracy, cost and stability as JSON; docs/report.md describes it.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "accuracy/data.hpp"

namespace vcrit::validation::report {

nlohmann::ordered_json accuracy_json(const accuracy::Accuracy& accuracy);

}  // namespace vcrit::validation::report
