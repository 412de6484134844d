// How much v* answers to one parameter, by differentiating Eq. 24 along with its evaluation.
#pragma once

#include "scene/scene.hpp"

namespace vcrit {

/// (p/v*) dv*/dp, without unit, for any symbol p of the scene that has a value (0 where v* does not
/// depend on it). In doubles: near a resonance or antiresonance it loses as many digits as v*
/// there; of drives that hold masses as good as v* itself. Throws ModelError for a measured drive,
/// and where v* is 0 or infinite.
double log_derivative(const Scene& scene, const Symbol& symbol);

}  // namespace vcrit
