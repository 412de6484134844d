// The contact network in both of its states. Sticking, its deformation is given and its Maxwell
// branches relax on their own; slipping, its force is given and its Kelvin units creep on their
// own. Both are kept as rates, which neither a slow branch's load nor a fast one's stiffness
// drowns:
//   rho_i = d(force of branch i)/dt,   rho_i' = k_i e'' - a_i rho_i,     a_0 = 0 the spring,
//   r_j   = d(strain of unit j)/dt,    r_j'   = psi_j F' - beta_j r_j,
// with e' = J_g F' + phi F + sum_j r_j, and rho_i = k_i (J_g F' + sum_j beta_j r_j/(beta_j - a_i)).
// The way back, r_j = psi_j sum_i rho_i/(beta_j - a_i), is never taken: for slow units it is a
// small difference of large terms. In stick the r_j are carried along instead, driven by F'.
#pragma once

#include "modes/spectrum.hpp"
#include "stiffness/relaxation.hpp"

namespace vcrit::simulation {

struct ContactModes {
  double damper = 0;        ///< c_inf; where positive the force depends on the contact velocity
  double glassy = 0;        ///< J_g, 0 with a direct damper
  double fluidity = 0;      ///< phi, 0 where a spring carries a static load
  Vector branch_rates;      ///< a_i
  Vector branch_stiffness;  ///< k_i
  Vector unit_rates;        ///< beta_j
  Vector unit_fluidity;     ///< psi_j
  Matrix to_branches;       ///< k_i beta_j/(beta_j - a_i)
};

/// Full matrices of them are kept, some dozen.
inline constexpr Index most_moving_branches = 4000;

/// Throws ModelError for more branches than that.
ContactModes contact_modes(const Relaxation& contact);

}  // namespace vcrit::simulation
