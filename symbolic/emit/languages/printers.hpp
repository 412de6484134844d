// The file of each language but its banner.
#pragma once

#include <string>

#include "emit/languages/evaluator.hpp"

namespace vcrit::symbolic {

std::string c99_text(const Evaluator& evaluator, const std::string& name);
std::string python_text(const Evaluator& evaluator);
std::string javascript_text(const Evaluator& evaluator);
std::string cuda_text(const Evaluator& evaluator, const std::string& name);

}  // namespace vcrit::symbolic
