// The condition number of Eq. 24: how far relative errors of a scene's numbers can grow on the way
// to v*. Tellegen's bound for the networks, and the cancellation near resonance and antiresonance.
#pragma once

#include "scene/scene.hpp"

namespace vcrit::validation {

/// A number >= 3 + 2 sqrt 2, infinite exactly at (anti)resonance. `values` are those of the scene.
/// Throws ModelError outside the table of a measured drive.
double condition_number(const Scene& scene, const Values& values);

}  // namespace vcrit::validation
