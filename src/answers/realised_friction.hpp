// Friction of a measured drive rests on the structure that was fitted to its table: how much the
// friction ratio may be off by that, and what of the table it rests on.
#pragma once

#include <string>
#include <vector>

#include "problem/problem.hpp"
#include "simulation/system/steady_state.hpp"

namespace vcrit {

struct RealisedFriction {
  int pairs = 0;                ///< oscillating motions of the structure
  double misfit = 0;            ///< largest relative one, over the table
  double misfit_at_omega = 0;   ///< stated error of R_d there, relative
  double critical_velocity = 0; ///< Eq. (24) with the structure's R_d, m/s
  std::vector<int> outside;     ///< harmonics of omega that are beyond the table, of the first eight
  double error = 0;             ///< what the fit adds to the error of the friction ratio
  std::vector<std::string> warnings;
};

/// Of a problem with a measured drive, at a velocity of the drive (m/s) with that steady state. To
/// first order the error of R_d at n omega moves the ratio by its own sensitivity, found from
/// structures with one small mode more each; the ratio is never off by more than it can be. Throws
/// ModelError where such a structure has no steady state.
RealisedFriction realised_friction(const Problem& problem, double velocity,
                                   const simulation::SteadyState& state);

/// What to say of friction of a measured drive where its error is not stated; empty for others.
std::vector<std::string> unstated_error(const Problem& problem);

}  // namespace vcrit
