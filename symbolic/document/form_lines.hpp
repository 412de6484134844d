// The lines of a result's form that was asked for beside the derivation.
#pragma once

#include <vector>

#include "document/print.hpp"
#include "formula/line.hpp"

namespace vcrit::symbolic {

/// None for a form that is the derivation's own.
std::vector<Line> form_lines(const Scene& scene, const DocumentOptions& options);

}  // namespace vcrit::symbolic
