// The page about the networks of a scene as materials: stiffness, storage and loss, spectra, creep
// and relaxation; then v* with what its formula says, and its limits.
#pragma once

#include <string>

#include "problem/problem.hpp"

namespace vcrit::validation::report {

/// HTML in one file, the same bytes in every run. In symbols where that is closed and readable, and
/// in numbers and curves where the elements have values.
std::string material_page(const Problem& problem);

}  // namespace vcrit::validation::report
