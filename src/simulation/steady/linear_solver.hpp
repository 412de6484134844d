// Small systems of linear equations by elimination with complete pivoting, which minds neither bad
// scaling of rows and columns nor a missing rank.
#pragma once

#include "simulation/motion/storage.hpp"

namespace vcrit::simulation {

class LinearSolver {
 public:
  /// a: square. Directions in which it is singular within rounding are left out of solutions.
  explicit LinearSolver(Matrix a);

  Vector solve(ConstView right) const;
  /// With the transposed matrix.
  Vector solve_transposed(ConstView right) const;

 private:
  void pivot(Index k);

  Index n_, rank_ = 0;
  Matrix lu_;
  List<Index> row_, column_;  ///< of the original matrix, by place
};

}  // namespace vcrit::simulation
