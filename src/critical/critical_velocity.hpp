// Eq. 24 in doubles: the critical velocity up to which friction can be controlled,
//   v* = mu0 omega du_z |K_n|/|K_t| |K_t + K_d - m omega^2|/|K_d - m omega^2|,
// where a rigid drive leaves mu0 omega du_z |K_n|/|K_t|, and an isotropic contact K_n/K_t a number.
#pragma once

#include "problem/problem.hpp"

namespace vcrit {

/// v* in m/s, the mean velocity of the contact point; every symbol of the scene must have a value.
/// Infinite at resonance, 0 at antiresonance, NaN where Eq. 24 is 0/0. Throws ModelError outside
/// the table of a measured drive.
double critical_velocity(const Problem& problem);
/// The same at another angular frequency (rad/s).
double critical_velocity(const Problem& problem, double omega);

}  // namespace vcrit
