// From the amplitude B, a rational function of s, to the root in v* = omega |B|: polynomials,
// their even and odd parts at s = i omega, and what the absolute value is of.
#pragma once

#include <vector>

#include "analysis/abbreviations.hpp"
#include "derivation/derivation.hpp"
#include "document/content.hpp"

namespace vcrit::symbolic {

/// None where nothing but real numbers is multiplied. In g and Z where these make it shorter.
std::vector<DocumentBlock> root_steps(const Derivation& derivation, const Abbreviations& names);

}  // namespace vcrit::symbolic
