// The whole scene drawn: what slides, what is between, what pulls, and the normal direction.
#pragma once

#include <string>

#include "scene/scene.hpp"

namespace vcrit::validation::report {

/// Substrate, contact point, tangential network, and whatever the scene has behind it; an <svg>.
std::string draw_sliding(const Scene& scene);

/// Substrate, normal network and the imposed oscillation; an <svg>.
std::string draw_normal(const Scene& scene);

}  // namespace vcrit::validation::report
