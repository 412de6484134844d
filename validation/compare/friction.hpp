// The friction curve and one steady cycle of a scene, and what they must obey whatever the scene:
// one steady value whatever the start.
#pragma once

#include <vector>

#include "compare/scene_report.hpp"
#include "simulation/system/system.hpp"

namespace vcrit::validation {

/// The speeds of a curve over the critical speed of the drive: even, with more of them near 1,
/// where stick dies out, and some beyond.
std::vector<double> curve_ratios();

/// Friction at `ratio` x `threshold`, threshold in m/s. Throws ModelError (no steady state).
ComparedPoint friction_at(const simulation::System& system, double threshold, double ratio);

/// mu_macro/mu0 of an elastic contact under a rigid drive without mass at `ratio` = v0/v* > 0,
/// with D = du_z/u_z0: 1 - D G(ratio), where stick begins at tau1 = pi + asin(ratio), ends at the
/// first root after it of ratio (tau2 - tau1) = cos tau2 - cos tau1, and G is what stick takes
/// away.
double elastic_friction(double amplitude_ratio, double ratio);

/// The worst point of the curve against each rule.
Comparison compare_starts(const std::vector<ComparedPoint>& curve);
Comparison compare_closed_form(const std::vector<ComparedPoint>& curve);

}  // namespace vcrit::validation
