// The relaxation form of a spring-damper network: however wired, it acts on its terminals like an
// equilibrium spring, a direct damper and Maxwell branches in parallel,
//   K(s) = k_inf + c_inf s + sum_j k_j s/(s + 1/tau_j),   all k_j > 0, tau_j > 0 real.
#pragma once

#include <complex>
#include <vector>

#include "network/network.hpp"

namespace vcrit {

struct MaxwellBranch {
  double stiffness = 0;  ///< k_j > 0 (N/m)
  double time = 0;       ///< tau_j > 0 (s)
};

struct Relaxation {
  double equilibrium = 0;               ///< k_inf (N/m), 0 for a fluid-like network
  double damper = 0;                    ///< c_inf (N s/m)
  std::vector<MaxwellBranch> branches;  ///< by increasing time, times all different
};

/// The relaxation form of a network whose elements all have positive values.
Relaxation relaxation_form(const Network& network, const Values& values);

/// K(i omega) of the form.
std::complex<double> dynamic_stiffness(const Relaxation& relaxation, double omega);

/// All stiffnesses and dampers times `factor`.
Relaxation scaled(Relaxation relaxation, double factor);

}  // namespace vcrit
