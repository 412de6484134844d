// How much errors of a scene's numbers can grow on the way to v*.
#pragma once

#include "scene/scene.hpp"

namespace vcrit::validation {

/// Bound on the relative change of v* over that of all numbers of the scene: Tellegen's bound for
/// the networks, and the cancellation near resonance and antiresonance (docs/report.md). Infinite
/// at these.
double condition_number(const Scene& scene, const Values& values);

}  // namespace vcrit::validation
