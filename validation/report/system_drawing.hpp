// The whole scene drawn as it stands: a substrate, what is between, the body and what pulls it.
#pragma once

#include "problem/problem.hpp"
#include "report/network_drawing.hpp"

namespace vcrit::validation::report {

/// Upright, with the numbers of its elements where there are few. What would be too wide for a
/// phone has its drive above the body, and its numbers below the drawing. What the scene lacks is
/// left out. Every value must be given.
Picture draw_system(const Problem& problem);

}  // namespace vcrit::validation::report
