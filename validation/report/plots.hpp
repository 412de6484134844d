// Single pictures of a scene for `vcrit plot`, in the units of their axes.
#pragma once

#include <optional>
#include <vector>

#include "figures/figure.hpp"
#include "problem/problem.hpp"

namespace vcrit::validation::report {

/// Mean friction with vibration over that without, over the velocity of the drive up to `to` (m/s;
/// none: 1.3 times the lowest velocity of continuous sliding). Throws InputError for missing
/// values, ModelError where the scene has no motion that is known, and where v* is 0 or infinite
/// and `to` is not given.
std::vector<figures::Figure> friction_plot(const Problem& problem, std::optional<double> to);

/// v* over the frequency, two decades to both sides of the scene's own and further where the scene
/// relaxes or resonates. Throws InputError for missing values, ModelError where v* is known at one
/// frequency alone.
std::vector<figures::Figure> frequency_plot(const Problem& problem);

/// Force on the contact point and its velocity over one period of steady motion at `velocity` (m/s)
/// of the drive. Throws as friction_plot does.
std::vector<figures::Figure> cycle_plot(const Problem& problem, double velocity);

}  // namespace vcrit::validation::report
