// The numbers of a scene as a table: symbol, value, unit, and what it is.
#pragma once

#include "compare/scene_report.hpp"

namespace vcrit::validation {

/// In the order of writing: oscillation and friction, what moves, then the networks' elements.
/// Throws InputError for missing values.
std::vector<ValueLine> value_lines(const Problem& problem);

/// Poisson's ratio or the ratio of stiffnesses where the scene has one: none where its two networks
/// are equal, which makes a contact isotropic, too.
const Isotropic* given_ratio(const Problem& problem);

}  // namespace vcrit::validation
