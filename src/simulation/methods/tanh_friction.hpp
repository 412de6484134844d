// Friction as a smooth function of the velocity, F = b(t) tanh(w/w_reg), in one system of
// equations for all time. The contact point has no mass, so that w follows from
//   c (u - w) + sum f_j = b tanh(w/w_reg),
// which has one root, since the left side falls with w and the right side rises. Without a direct
// damper w would be infinite where the force exceeds b by a rounding error; such contacts are given
// one, c = w_reg/v0 in units without dimensions.
#pragma once

#include <memory>

#include "simulation/methods/methods.hpp"
#include "simulation/methods/period_map.hpp"

namespace vcrit::simulation::methods {

std::unique_ptr<PeriodMap> tanh_map(const System& system, double velocity,
                                    const MethodOptions& options);

}  // namespace vcrit::simulation::methods
