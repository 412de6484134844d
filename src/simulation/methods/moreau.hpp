// Moreau-Jean time stepping: one implicit step after the other, blind to events. Over a step h,
// with x_theta = (1 - theta) x_0 + theta x_1 for forces of branches and the body's velocity,
//   (f_1 - f_0)/h = k e' - a f_theta,   m (u_1 - u_0)/h = F_drive - F,   F = c e' + sum f_theta,
// F is affine in the body's velocity u_theta, so Coulomb's law for F and w is one scalar
// complementarity problem: stick if the force it takes is within the bound, else slip.
//
// In slip the contact relaxes towards the bound with K_g/c, at once without a damper. Where that is
// faster than the step, theta < 1 - c/(K_g h) would make F ring about the bound and slip chatter;
// the law is then imposed on F at that point of the step, at its end without a damper.
#pragma once

#include <memory>

#include "simulation/methods/methods.hpp"
#include "simulation/methods/period_map.hpp"

namespace vcrit::simulation::methods {

std::unique_ptr<PeriodMap> moreau_map(const System& system, double velocity,
                                      const MethodOptions& options);

}  // namespace vcrit::simulation::methods
