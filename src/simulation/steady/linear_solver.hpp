// Small systems of linear equations by elimination with complete pivoting, after rows have been
// brought to one size: equations may be of any scale, and a missing rank does no harm.
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
  Vector scale_;              ///< of each row
  List<Index> row_, column_;  ///< of the original matrix, by place
};

}  // namespace vcrit::simulation
