// The whole scene drawn: what slides, what is between, what pulls, and the normal direction.
#pragma once

#include "report/network_drawing.hpp"
#include "scene/scene.hpp"

namespace vcrit::validation::report {

/// Substrate, contact point, tangential network, and whatever the scene has behind it.
Picture draw_sliding(const Scene& scene);

/// Substrate, normal network and the imposed oscillation.
Picture draw_normal(const Scene& scene);

}  // namespace vcrit::validation::report
