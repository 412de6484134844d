// The pictures of friction below an indenter.
#pragma once

#include <vector>

#include "compare/scene_report.hpp"
#include "figures/figure.hpp"

namespace vcrit::validation::report {

/// Friction over speed by amplitude and by shape, and the state of the contact over its width.
std::vector<figures::Figure> indenter_figures(const Indented& indented);

}  // namespace vcrit::validation::report
