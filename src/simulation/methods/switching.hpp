// Adaptive integration with switching at located events, as one period after the other.
#pragma once

#include <memory>

#include "simulation/methods/methods.hpp"
#include "simulation/methods/period_map.hpp"

namespace vcrit::simulation::methods {

/// method: rkf45, rk8pd or msbdf.
std::unique_ptr<PeriodMap> switching_map(Method method, const System& system, double velocity,
                                         const MethodOptions& options);

}  // namespace vcrit::simulation::methods
