// The sensitivities of a scene as numbers, below those of its formula.
#pragma once

#include <string>

#include "problem/problem.hpp"

namespace vcrit::symbolic {

/// A line for each number of the scene that matters, the largest first; nothing where some have no
/// value, or v* has none.
std::string shares_text(const Problem& problem);

}  // namespace vcrit::symbolic
