// What presses the cells below an indenter together: the integral of their mean normal forces, each
// under its own mean indentation u_z0 - g(x).
#pragma once

#include "normal/mean_indentation.hpp"

namespace vcrit::simulation {

/// The mean indentation (m) of an indenter under the load of the problem. Throws InputError for
/// missing values, ModelError where the half-space carries no static load or no normal force of a
/// cell is found.
double indentation_of_cells(const Problem& problem);

/// The mean normal force (N) at the mean indentation that the problem has. Throws likewise.
double mean_force_of_cells(const Problem& problem);

}  // namespace vcrit::simulation
