// The whole scene drawn as it stands: a substrate, what is between, the body and what pulls it.
#pragma once

#include "problem/problem.hpp"
#include "report/network_drawing.hpp"

namespace vcrit::validation::report {

/// Upright, with the numbers of its elements where there are few. What the scene lacks is left out.
/// Every value must be given.
Picture draw_system(const Problem& problem);

}  // namespace vcrit::validation::report
