// What the page of a scene says of surfaces that may part.
#pragma once

#include <string>
#include <vector>

#include "figures/figure.hpp"
#include "scene_report.hpp"

namespace vcrit::validation::report {

/// Empty for surfaces that never do.
std::string parting_section(const SceneReport& report);

/// Friction over speed at some amplitudes, and what the contact does over the period at each speed.
figures::Figure amplitude_figure(const Parting& parting);
figures::Figure state_figure(const Parting& parting);

}  // namespace vcrit::validation::report
