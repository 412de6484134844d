// The pictures of a contact that may open.
#pragma once

#include "compare/scene_report.hpp"
#include "figures/figure.hpp"

namespace vcrit::validation::report {

/// Friction over speed at some amplitudes, and what the contact does over the period at each speed.
figures::Figure amplitude_figure(const Separation& separation);
figures::Figure state_figure(const Separation& separation);

}  // namespace vcrit::validation::report
