// A viscoelastic indenter on a drive that gives, below the speed above which all cells slide: so
// many cells in small steps of time. Cells that stuck together remember different things, since
// each creeps on while it slides; no few numbers tell what all of them remember.
//
// The normal force of each cell is exact (normal_cycle.hpp). In a step the way of the body is
// linear in time, and so is the deformation of a cell, unless friction holds it back: all branches
// relax exactly, and what a cell carries is cut at its bound at the end of the step. In the units
// of rim.hpp.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "indenter/collocation.hpp"
#include "indenter/rim.hpp"

namespace vcrit::indenter {

class HeldCells {
 public:
  /// count: of cells, shared by the panels; steps: of a period.
  HeldCells(const HalfSpace& half_space, const ScaledContact& contact, const ScaledHolder& holder,
            int count, int steps);

  struct Steady {
    double ratio = 0;
    double open = 0;  ///< what the ratio may change by until the motion repeats
    bool backslip = false;
  };
  /// At a speed of the drive > 0; sliding: one at which all cells slide. Throws ModelError where
  /// the motion does not repeat.
  Steady steady(double velocity, double sliding, SharedEffort* whole) const;

 private:
  struct Period {
    double friction = 0;  ///< summed over the steps
    bool backslip = false;
  };

  void place_cells(const HalfSpace& half_space, const MemoryCells& cells, double unit, int count);
  Period period(StateVector& state, double velocity, Effort& effort) const;
  double pulled(const Eigen::ArrayXd& relaxed, Eigen::Index step, double way, double& slope) const;
  double size(const StateVector& change) const;

  const ScaledHolder& holder_;
  Eigen::Index count_ = 0, steps_, branches_, body_;
  double step_, share_;
  Eigen::ArrayXd weights_, glassy_;  ///< of each cell: stiffness of a unit modulus, and at once
  Eigen::ArrayXd left_, gained_;     ///< of each branch over a step, of a unit stiffness
  std::vector<double> held_left_, held_gained_;  ///< the same of the drive
  double slope_ = 0;                             ///< of the body's balance over its way
  Eigen::MatrixXd bounds_;                       ///< a column a step
  double bound_ = 0;                             ///< all of them
};

}  // namespace vcrit::indenter
