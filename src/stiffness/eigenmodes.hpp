// Eigenvalues of a symmetric matrix B without its last row and column, and how strongly the last
// row couples to each. They give the last diagonal entry of a resolvent:
//   1/[(B - x)^-1]_nn = b_nn - x - sum_j coupling_j^2/(value_j - x),
// where coupling_j is the component of the last row along eigenvector j.
#pragma once

#include <optional>
#include <vector>

#include "stiffness/big_float.hpp"

namespace vcrit {

using SymmetricRows = std::vector<std::vector<BigFloat>>;  ///< row i up to its diagonal

struct Eigenmode {
  BigFloat value, squared_coupling;
};

/// Sorted by value; a multiple eigenvalue appears several times, and rounding decides how the
/// copies share its coupling. The result is exact for a matrix near B: they differ by a few
/// rounding errors of B's norm per row. B has at least one row, and all its numbers have the same
/// number of bits. Returns nothing if the iteration does not converge.
std::optional<std::vector<Eigenmode>> modes_coupled_to_last_row(SymmetricRows matrix);

}  // namespace vcrit
