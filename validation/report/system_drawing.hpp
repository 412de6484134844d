// The whole scene drawn: what slides, what is between, what pulls, and the normal direction.
#pragma once

#include "problem/problem.hpp"
#include "report/network_drawing.hpp"

namespace vcrit::validation::report {

/// Substrate, contact point, tangential network, and whatever the scene has behind it.
Picture draw_sliding(const Problem& problem);

/// Substrate, normal network and the imposed oscillation.
Picture draw_normal(const Problem& problem);

}  // namespace vcrit::validation::report
