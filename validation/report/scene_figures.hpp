// The pictures of one scene.
#pragma once

#include <string>
#include <vector>

#include "figures/figure.hpp"
#include "report/scene_contents.hpp"

namespace vcrit::validation::report {

/// All that the scene has.
std::vector<figures::Figure> scene_figures(const SceneContents& contents);

/// mu_macro/mu0 over the speed in units of the critical speed of the drive.
figures::Figure friction_figure(const SceneReport& report);

/// How far each other method of report.methods is from the exact one, over the same speed.
figures::Figure residual_figure(const SceneReport& report);

/// What the speed axis shows: "v0 / v*", or with creep "v0 / (v* + creep)".
std::string speed_axis(const SceneReport& report);

}  // namespace vcrit::validation::report
