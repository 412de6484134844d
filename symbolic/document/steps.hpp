// From the amplitude B, a rational function of s, to the root in v* = omega |B|: polynomials,
// their even and odd parts at s = i omega, and what the absolute value is of.
#pragma once

#include <vector>

#include "derivation/derivation.hpp"
#include "document/content.hpp"

namespace vcrit::symbolic {

/// None where nothing but real numbers is multiplied.
std::vector<DocumentBlock> root_steps(const Derivation& derivation);

}  // namespace vcrit::symbolic
