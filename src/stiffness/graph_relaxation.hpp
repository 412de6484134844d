// The relaxation form of a graph of networks, by the symmetric eigenproblem of its nodal pair:
// with stiffness matrix A and damping matrix C of the inner nodes, A x = mu (A/alpha + C) x, and
//   K(s) = A_00 + s C_00 - sum_j (p_j + s q_j)^2/(mu_j + s nu_j),   nu_j = 1 - mu_j/alpha.
// A/alpha + C is positive definite even where C is singular (nodes without a damper move at once:
// nu = 0). The pair is graded over as many decades as the elements, and what is left is small
// against what is subtracted, so all of it is done with 100 decimal digits.
#pragma once

#include <cstddef>
#include <vector>

#include "stiffness/relaxation.hpp"

namespace vcrit {

/// Edge i, of the form edges[i], lies between nodes wires[i]; the terminals are nodes 0 and 1,
/// every node is connected with them. Times that agree to rounding become one branch, and branches
/// of less than 1e-30 of K are left out.
Relaxation graph_relaxation(std::size_t nodes, const std::vector<Wire>& wires,
                            const std::vector<Relaxation>& edges);

}  // namespace vcrit
