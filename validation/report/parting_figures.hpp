// The pictures of surfaces that may part.
#pragma once

#include "compare/scene_report.hpp"
#include "figures/figure.hpp"

namespace vcrit::validation::report {

/// Friction over speed at some amplitudes, and what the contact does over the period at each speed.
figures::Figure amplitude_figure(const Parting& parting);
figures::Figure state_figure(const Parting& parting);

}  // namespace vcrit::validation::report
