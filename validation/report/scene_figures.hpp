// The pictures of one scene.
#pragma once

#include <string>
#include <vector>

#include "figures/figure.hpp"
#include "scene_report.hpp"

namespace vcrit::validation::report {

/// mu_macro/mu0 over the speed in units of the lowest speed of pure sliding.
figures::Figure friction_figure(const SceneReport& report);

/// Tangential force and friction bound over one period of report.cycle, stick and backward slip
/// shaded.
figures::Figure force_figure(const SceneReport& report);

/// Velocity of the contact point over the same period.
figures::Figure velocity_figure(const SceneReport& report);

/// What the speed axis shows: "v0 / v*", or with creep "v0 / (v* + creep)".
std::string speed_axis(const SceneReport& report);

/// A stretch of one period in which the contact does not slip forward; times in the given unit.
struct Stretch {
  double from = 0, to = 0;
  bool backward = false;  ///< slips backward; else sticks
};
std::vector<Stretch> stretches(const std::vector<simulation::CyclePoint>& cycle, double per_phase);

}  // namespace vcrit::validation::report
