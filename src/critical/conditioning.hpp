// How much errors of a scene's numbers can grow on the way to v*, and so how far two ways to v* may
// be apart: one answer for all that compare them.
#pragma once

#include "problem/problem.hpp"

namespace vcrit {

/// Bound on the relative change of v* over that of all numbers of the scene: Tellegen's bound for
/// the networks, and the cancellation near resonance and antiresonance (docs/report.md). Infinite
/// at these.
double condition_number(const Problem& problem, const Values& values);

/// Relative, of v* by Eq. (24) in doubles: 32 roundings, each grown by the condition number.
double formula_tolerance(double condition);

/// What the simulator promises of v* where it has digits to lose: six of the sixteen.
inline constexpr double motion_promise = 1e-9;

/// Of v* by motion, as where the last stick ends, and by the harmonic balance of the networks in
/// relaxation form: as of the formula, and no less than the promise.
double motion_tolerance(double condition);

/// Whether a comparison to that tolerance says anything.
bool leaves_digits(double tolerance);

}  // namespace vcrit
