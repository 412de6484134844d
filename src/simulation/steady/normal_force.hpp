// The steady normal force, which does not depend on what the contact does along the surface.
#pragma once

#include "simulation/system/system.hpp"

namespace vcrit::simulation {

/// <F_n> in N. Of a contact that opens: 0 where the contact never closes.
double mean_normal_force(const System& system);

}  // namespace vcrit::simulation
