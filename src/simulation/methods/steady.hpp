// The steady cycle of a period map: plain periods until they repeat, or Newton's method with the
// map's derivative by differences.
#pragma once

#include "simulation/methods/methods.hpp"
#include "simulation/methods/period_map.hpp"

namespace vcrit::simulation::methods {

SteadyState settle(PeriodMap& map, const MethodOptions& options);

}  // namespace vcrit::simulation::methods
