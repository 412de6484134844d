// Of a scene whose contact may open: v* of the motion, friction against amplitude across the
// border of separation, the state of the contact over the period, and the limits that must hold.
#pragma once

#include "answers/critical_onset.hpp"
#include "compare/scene_report.hpp"
#include "simulation/system/system.hpp"

namespace vcrit::symbolic {
struct Derivation;
}

namespace vcrit::validation {

/// Adds `separation` and its comparisons. System and onset are the scene's.
void examine_separation(SceneReport& report, const symbolic::Derivation& derivation,
                        const simulation::System& system, const CriticalOnset& onset);

/// In what curves and maps measure speed, m/s: v* by Eq. 24, or where that is 0 or infinite v*
/// under a rigid drive.
double unit_of_speed(const Problem& problem);

/// Amplitude over indentation beyond which the contact opens, K_n(0)/|K_n(i omega)|; the amplitude
/// is the vibrator's above a mount.
double opening_border(const Problem& problem);

/// The longest time (s) in which a solid forgets what was done to it, by order of magnitude; 0 of
/// an elastic one.
double slowest_relaxation(const Relaxation& solid);

/// A comparison of two numbers by their difference, still without them.
Comparison by_difference(const char* key, const char* name, const char* reference);

/// What the contact does at each of `phases` of a steady state of one period.
std::vector<std::optional<simulation::Motion>> motions_in(const simulation::SteadyState& state,
                                                          const std::vector<double>& phases);

}  // namespace vcrit::validation
