// All that is wrong with a scene's text, for who would mend it in one go.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/complaints.hpp"
#include "base/errors.hpp"
#include "problem/problem.hpp"

namespace vcrit {

struct ProblemFindings {
  std::vector<InputError> errors;  ///< by line
  std::vector<Warning> warnings;   ///< by line
  std::optional<Problem> problem;  ///< where there is no error
};

/// Of the text of a scene that `file` names.
ProblemFindings examine_problem(const std::string& text, const std::string& file);

}  // namespace vcrit
