// Of a scene with an indenter: friction against amplitude and shape, the state of the contact over
// width and period, and the limits that must hold.
#pragma once

#include "answers/critical_onset.hpp"
#include "compare/scene_report.hpp"
#include "compare/witnesses.hpp"
#include "indenter/half_space.hpp"

namespace vcrit::validation {

/// The force (N) of the half-space at rest under a depth (m), the springs' sum, by another
/// quadrature than that of the cells.
double static_force(const indenter::HalfSpace& half_space, double depth);

/// Adds `indented` and its comparisons. onset: the scene's. Throws ModelError where cells have no
/// steady state.
void examine_indenter(SceneReport& report, const CriticalOnset& onset, const Witnesses& witnesses);

}  // namespace vcrit::validation
