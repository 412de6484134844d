// The relaxation form of a graph of networks, by the symmetric eigenproblem of its nodal pair:
// with stiffness matrix A and damping matrix C of the inner nodes, A x = mu (A/alpha + C) x, and
//   K(s) = A_00 + s C_00 - sum_j (p_j + s q_j)^2/(mu_j + s nu_j),   nu_j = 1 - mu_j/alpha.
// A/alpha + C is positive definite even where C is singular (nodes without a damper move at once:
// nu = 0). The pair is graded over as many decades as the elements, and what is left is small
// against what is subtracted, so all of it is done with 100 decimal digits.
#pragma once

#include <cstddef>

#include "stiffness/condensation.hpp"

namespace vcrit {

/// Time grows with the cube of these: a minute for so many.
constexpr std::size_t most_modes = 200;

/// Times that agree to rounding become one branch, and branches of less than 1e-30 of K are left
/// out. Throws InputError where inner nodes and branches of the edges are more than `most_modes`.
Relaxation graph_relaxation(const RelaxationGraph& graph);

}  // namespace vcrit
