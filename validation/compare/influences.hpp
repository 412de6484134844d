// What decides v*: how much it answers to each number of the scene.
#pragma once

#include "compare/scene_report.hpp"

namespace vcrit::validation {

/// Of the numbers in `lines` and of Poisson's ratio, or the ratio that stands for it, the largest
/// first; those of no influence are left out. Empty where v* is 0, infinite, or not known.
std::vector<Influence> influences(const Problem& problem, std::vector<ValueLine> lines);

/// Nothing where the contact carries no load at rest.
std::optional<NormalForce> normal_force(const Problem& problem);

}  // namespace vcrit::validation
