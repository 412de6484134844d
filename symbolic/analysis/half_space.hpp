// Below an indenter, by the method of dimensionality reduction: springs side by side, of stiffness
// E* dx along the normal and G* dx along the surface, E* = E/(1 - nu^2), G* = 4 G/(2 - nu).
#pragma once

#include <vector>

#include "derivation/derivation.hpp"
#include "formula/line.hpp"

namespace vcrit::symbolic {

/// Why one v* holds for all of them, and thereby for any shape. Throws InputError without one.
std::vector<Line> half_space_lines(const Derivation& derivation);

}  // namespace vcrit::symbolic
