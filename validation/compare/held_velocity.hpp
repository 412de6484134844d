// v* of an indenter on a drive that gives by Fourier's series: each harmonic of the normal force
// moves the body by what the drive answers at that frequency. It shares the scene's numbers with
// what it checks (src/indenter/rim_sliding.hpp), which integrates the body's motion in time.
#pragma once

#include "answers/critical_onset.hpp"
#include "compare/scene_report.hpp"
#include "indenter/half_space.hpp"

namespace vcrit::validation {

/// Of a finite v* > 0.
Comparison compare_held_velocity(const indenter::HalfSpace& half_space, const CriticalOnset& onset);

}  // namespace vcrit::validation
