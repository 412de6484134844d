// The largest amplitude at which the contact stays closed (4): du_z |K_n(i omega)| < u_z0 K_n(0),
// or W. As |K(i omega)| of springs and dampers is nowhere below K(0), (3) asks for no more.
#pragma once

#include "problem/problem.hpp"
#include "shortest/shortest.hpp"

namespace vcrit::symbolic {

/// u_z0 K_n(0)/|K_n(i omega)|, or W/|K_n(i omega)| under a load, in named steps, as `velocity`,
/// proved to be that; none where the contact carries no load at rest, or where it fits no page.
FoundForm find_closed_amplitude(const Problem& problem);

}  // namespace vcrit::symbolic
