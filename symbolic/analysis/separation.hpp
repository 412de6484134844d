// Eq. (24) where the contact opens. In sliding it carries F = mu0 F_n at all times, closed and
// open, so that the contact point follows the normal deformation by the ratio of both
// stiffnesses. Where that ratio is a number, free of s, it follows without memory, and the closed
// form holds on whatever the contact does in between.
#pragma once

#include <vector>

#include "derivation/derivation.hpp"
#include "formula/line.hpp"

namespace vcrit::symbolic {

/// The derivation of v* for a contact that may open, or no lines where v* is not Eq. (24) then, by
/// rules/rulebook.hpp.
std::vector<Line> separation_lines(const Derivation& derivation);

}  // namespace vcrit::symbolic
