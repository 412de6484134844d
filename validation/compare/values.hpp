// The numbers of a scene as a table: symbol, value, unit, and what it is.
#pragma once

#include "compare/scene_report.hpp"

namespace vcrit::validation {

/// In the order of writing: oscillation and friction, what moves, then the networks' elements.
/// Throws InputError for missing values.
std::vector<ValueLine> value_lines(const Problem& problem);

}  // namespace vcrit::validation
