// One period of steady motion, drawn.
#pragma once

#include "compare/scene_report.hpp"
#include "figures/figure.hpp"

namespace vcrit::validation::report {

/// Tangential force and friction bound over one period of report.cycle, stick and backward slip
/// shaded.
figures::Figure force_figure(const SceneReport& report);

/// Velocity of the contact point over the same period.
figures::Figure velocity_figure(const SceneReport& report);

}  // namespace vcrit::validation::report
