// Small systems of linear equations by elimination with complete pivoting, after columns have
// been measured by the sizes of their unknowns and rows been brought to one size: equations and
// unknowns may be of any scale, and a missing rank does no harm.
#pragma once

#include "modes/storage.hpp"

namespace vcrit::simulation {

class LinearSolver {
 public:
  /// a: square; sizes: what each unknown is measured by, > 0. Directions in which it is singular
  /// within rounding are left out of solutions.
  LinearSolver(Matrix a, ConstView sizes);

  /// Numbers multiplied or compared to make one of n unknowns.
  static constexpr Index work(Index n) { return n * n * n; }

  Vector solve(ConstView right) const;
  /// With the transposed matrix.
  Vector solve_transposed(ConstView right) const;

 private:
  void pivot(Index k);

  Index n_, rank_ = 0;
  Matrix lu_;
  Vector scale_, size_;       ///< of each row, of each unknown
  List<Index> row_, column_;  ///< of the original matrix, by place
};

}  // namespace vcrit::simulation
