// The pictures of a scene's answer, in the units of its file: mm/s, kHz, N.
#pragma once

#include <optional>

#include "figures/figure.hpp"
#include "report/scene_contents.hpp"

namespace vcrit::validation::report {

/// Mean friction with vibration over that without, over the sliding speed up to 1.3 v*; none where
/// nothing was simulated or v* has no end.
std::optional<figures::Figure> answer_figure(const SceneReport& report);

/// The normal force over one period if the surfaces could pull: where it is below 0 they open. None
/// where it never is, or no load is carried.
std::optional<figures::Figure> opening_figure(const SceneReport& report);

/// v* over the frequency, resonances marked; none where v* is known at one frequency alone.
std::optional<figures::Figure> frequency_figure(const SceneReport& report);

/// Stiffnesses of the networks over the frequency; likewise.
std::optional<figures::Figure> stiffness_figure(const SceneReport& report);

/// Friction ratio over the speed in units of v*, for a line of few pixels.
std::vector<std::pair<double, double>> answer_points(const SceneReport& report);

}  // namespace vcrit::validation::report
