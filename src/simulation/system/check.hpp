// What a system must be that was not made of a scene.
#pragma once

#include "simulation/system/system.hpp"

namespace vcrit::simulation {

/// Throws InputError with the member at fault: what works with a system asks this first.
void check_system(const System& system);

}  // namespace vcrit::simulation
