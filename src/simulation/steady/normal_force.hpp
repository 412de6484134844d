// The mean of the normal force, by which friction is measured.
#pragma once

#include "simulation/system/system.hpp"

namespace vcrit::simulation {

/// <F_n> in N. Of a contact that opens: 0 where the surfaces never meet.
double mean_normal_force(const System& system);

}  // namespace vcrit::simulation
