// Adaptive Gauss-Kronrod quadrature of the cells' normal force and friction over x, both at once,
// by 21 nodes a panel. Where panels meet functions may turn like (x - x0)^{k/2}: within each, x is
// a cubic polynomial with its extrema at the ends, in which that is smooth.
#pragma once

#include <vector>

#include "indenter/cell.hpp"

namespace vcrit::indenter {

/// Over all panels, from the middle to the edge.
struct PanelIntegrals {
  double friction = 0;            ///< N, of what friction divided by mu0 is
  double normal_force = 0;        ///< N
  double ratio_error = 0;         ///< of their quotient: estimate of the quadrature's error
  double normal_force_error = 0;  ///< N, the same of the normal force
  double cell_error = 0;          ///< N, in the friction: of the cells
  double disagreement = 0;        ///< largest of a cell
  Motions motions;                ///< of all cells
  int cells = 0;
};

/// `breaks` in m, increasing from 0 to the edge. Panels are halved until `ratio_error` and the
/// relative error of the normal force are below the tolerance, or lost in rounding errors.
/// The same to the bit whatever the number of threads.
PanelIntegrals integrals(const HalfSpace& half_space, double velocity,
                         const std::vector<double>& breaks, double tolerance);

}  // namespace vcrit::indenter
