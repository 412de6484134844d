// The relaxation form of a graph of networks, by a symmetric eigenproblem. Terminal 1 is held; A is
// the stiffness matrix and C the damping matrix of the other nodes, terminal 0 last. With
// A + alpha C = L L^T and B = L^-1 A L^-T,
//   A + s C = L (B + s/alpha (1 - B)) L^T.
// Leave out the last row and column of B: the eigenvalues 0 <= mu_j <= 1 of the rest give the rates
// alpha mu_j/(1 - mu_j) of the branches, and the couplings of the last row give their stiffness.
// A + alpha C is positive definite even if C is singular (mu = 1: a node without a damper).
// The matrices span as many decades as the elements, and large terms cancel. So the working
// precision is doubled until error bounds show that all digits of the result are right: balls bound
// the error of B, and a general bound covers the eigenvalue iteration.
#pragma once

#include <cstddef>

#include "stiffness/condensation.hpp"

namespace vcrit {

/// Run time grows with the cube of the modes: a few seconds for this many, half a minute if the
/// elements span 300 decades.
constexpr std::size_t most_modes = 200;

/// Each number is the double nearest to the exact one. Branches whose times agree to rounding
/// become one, and branches of less than 1e-30 of K are left out. Throws InputError if inner nodes
/// and branches of the edges are more than `most_modes`, and Bug if a number of an edge is not
/// finite.
Relaxation graph_relaxation(const RelaxationGraph& graph);

}  // namespace vcrit
