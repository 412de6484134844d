// The C++ files that are printed from one evaluator.
#pragma once

#include <string>

#include "emit/languages/evaluator.hpp"

namespace vcrit::symbolic {

std::string cpp_header(const Evaluator& evaluator, const std::string& name);
std::string cpp_batch_header(const Evaluator& evaluator, const std::string& name);
std::string cpp_test(const Evaluator& evaluator, const std::string& name);

}  // namespace vcrit::symbolic
