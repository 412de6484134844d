// What viscosity does to the friction of the full motion: at equal amplitude D it takes away more
// of it at any speed below v*; at equal amplitude a of the normal force less below a speed v_c, and
// more above.
#pragma once

#include "paper/contents.hpp"

namespace vcrit::validation::paper {

Viscosity compare_viscosities();

}  // namespace vcrit::validation::paper
