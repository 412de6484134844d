// What the page of a scene says of friction below an indenter.
#pragma once

#include <string>
#include <vector>

#include "figures/figure.hpp"
#include "scene_report.hpp"

namespace vcrit::validation::report {

/// Empty without an indenter.
std::string indenter_section(const SceneReport& report);

/// Friction over speed by amplitude and by shape, and the state of the contact over its width.
std::vector<figures::Figure> indenter_figures(const Indented& indented);

}  // namespace vcrit::validation::report
