// What a derivation needs beside its formulas to stand in a paper: what it assumes, what its
// symbols mean, with their units, and where the theory is from.
#pragma once

#include <vector>

#include "document/content.hpp"

namespace vcrit::symbolic {

/// The sections of a document that is not read in a terminal.
std::vector<DocumentSection> appendix(const Findings& findings);

}  // namespace vcrit::symbolic
