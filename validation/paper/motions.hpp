// The contact of the paper's Fig. 4 by the simulator: kelvin_contact(), in the units of
// contents.hpp.
#pragma once

#include "compare/reduced_difference.hpp"
#include "simulation/system/steady_state.hpp"

namespace vcrit::validation::paper {

/// v* by (31): mu0 omega du_z k_n/k_t, which is D = a/sqrt(1 + delta^2) here.
double kelvin_critical_velocity(double delta, double a);

/// At ratio = v0/v* > 0, by the exact method.
simulation::SteadyState full_motion(double delta, double a, double ratio);

/// mu_macro/mu0 at ratio = v0/v* > 0.
double full_friction(double delta, double a, double ratio);
double reduced_friction(double delta, double a, double ratio);

}  // namespace vcrit::validation::paper
