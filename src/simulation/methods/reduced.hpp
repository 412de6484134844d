// The paper's reduced model of stick-slip, (47)-(52): a Kelvin contact under a rigid drive without
// mass. With tau = omega t, delta = omega c/k, D sqrt(1 + delta^2) = amplitude of F_n over its mean
// (the normal network matters through that alone) and v = v0/v*, stick lasts from tau1 to tau2:
//   v = -sin tau1, cos tau1 < 0                                                              (50)
//   v (tau2 - tau1) = cos tau2 - cos tau1 - delta (v + sin tau2)                             (51)
//   mu_macro/mu0 = 1 - D/(2 pi) int_{tau1}^{tau2} f dtau,                                    (47)
//   f = cos tau - delta sin tau - v (tau - tau1) - cos tau1 - delta v                  (48), (49)
// It leaves out the part of the slip that decays with exp(-tau/delta): right for small delta and
// for v near 1, wrong elsewhere. The error answered is the size of that part where stick begins.
#pragma once

#include "simulation/methods/methods.hpp"

namespace vcrit::simulation::methods {

/// Throws ModelError naming what the system has that the model has not.
SteadyState reduced_model(const System& system, double velocity);

}  // namespace vcrit::simulation::methods
