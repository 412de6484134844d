// Friction of a measured drive rests on the structure that was fitted to its table: how much the
// friction ratio may be off by that, and what of the table it rests on.
#pragma once

#include <string>
#include <vector>

#include "problem/problem.hpp"

namespace vcrit {

struct RealisedFriction {
  int pairs = 0;                 ///< oscillating motions of the structure
  double misfit = 0;             ///< largest relative one, over the table
  double misfit_at_omega = 0;    ///< stated error of R_d there, relative
  double critical_velocity = 0;  ///< that of realised_velocity(), m/s
  std::vector<int> outside;  ///< harmonics of omega that are beyond the table, of the first eight
  double error = 0;          ///< what the fit adds to the error of the friction ratio
  std::vector<std::string> warnings;
};

/// Of a problem with a measured drive, at a velocity of the drive (m/s). The error is how far the
/// ratio moves with other structures that the table allows as well: refits to other noise, other
/// orders, and a mode that the rows do not show at a harmonic; the ratio is never off by more than
/// it can be. Throws ModelError where the structure has no steady state.
RealisedFriction realised_friction(const Problem& problem, double velocity);

/// v* of a problem with a measured drive, by the structure: Eq. (24) with its R_d, or of a contact
/// that opens the speed from which on its motion slides; infinite where none is enough.
struct RealisedVelocity {
  double value = 0;       ///< m/s
  double difference = 0;  ///< by which the drive's own may differ: by the error of the fit at
                          ///< omega, and by what a straight line between two rows leaves out; of a
                          ///< contact that opens by other structures that the table allows as well
};
RealisedVelocity realised_velocity(const Problem& problem);

/// What to say of friction of a measured drive where its error is not stated; empty for others.
std::vector<std::string> unstated_error(const Problem& problem);

}  // namespace vcrit
