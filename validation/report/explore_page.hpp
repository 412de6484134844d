// The page of `vcrit explore`: a scene whose parameters the reader moves, and nothing else.
#pragma once

#include <string>

#include "problem/problem.hpp"

namespace vcrit::validation::report {

/// Throws InputError for missing values, ModelError for a scene without an explorer.
std::string explore_page(const Problem& problem);

}  // namespace vcrit::validation::report
