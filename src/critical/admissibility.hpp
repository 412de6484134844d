// Where Eq. 24 applies: the amplitude is below the indentation (3), the contact stays closed (4),
// (35) and can carry its mean load at all; and how fast a fluid-like path creeps under the mean
// friction force.
#pragma once

#include <string>
#include <vector>

#include "problem/problem.hpp"

namespace vcrit {

/// Why the scene is not admissible, one sentence a reason; empty when it is. A contact that may
/// open need not stay closed.
std::vector<std::string> inadmissible_reasons(const Problem& problem);

/// Whether the normal force would pull for a part of the period (4), under an indenter the pressure
/// at its centre: the contact opens there if the scene lets it. Throws InputError for missing
/// values.
bool opens(const Problem& problem);

/// mu0 <F_n> (1/eta_t + 1/eta_d) in m/s: what the drive must run faster than the contact point;
/// 0 where both networks carry a static load.
double creep_velocity(const Problem& problem);

}  // namespace vcrit
