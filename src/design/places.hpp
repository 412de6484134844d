// Rows of places that a search asks at.
#pragma once

#include <vector>

namespace vcrit::design {

/// The bounds themselves are not admissible: there the normal force touches zero.
inline constexpr double inside_the_bound = 0.999999;

/// Speeds below this part of what the contact's velocity oscillates by are not asked for, nor are
/// amplitudes below this part of the largest: friction is within its square root of the static
/// limit there.
inline constexpr double slowest = 1e-9;

/// From a to b, both included: evenly, or by even ratios.
std::vector<double> even(double a, double b, int samples);
std::vector<double> even_ratios(double a, double b, int samples);

}  // namespace vcrit::design
