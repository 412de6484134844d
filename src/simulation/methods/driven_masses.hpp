// A drive that holds masses, by the equations of motion of its masses, in the units of
// equations.hpp: velocities q' in the frame of the far end, and the forces of all that holds them,
//   M q'' = -C q' - sum g_j f_j - F p,   f_j' = k_j g_j.q' - a_j f_j, a spring has a_j = 0,
// with F on the body's end and p.q its displacement. The exact method goes another way, by the
// motion that the body sees (stiffness/drive_motion.hpp).
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "stiffness/drive_structure.hpp"

namespace vcrit::simulation::methods {

class DrivenMasses {
 public:
  /// stiffness_unit: N/m.
  DrivenMasses(const DriveStructure& structure, double omega, double stiffness_unit);

  std::size_t size() const { return static_cast<std::size_t>(rates_.rows()); }  ///< of (q', f_j)
  /// p.q', of the body's end in the frame of the far end.
  double end_velocity(const double* x) const;
  /// x' = A x + F push.
  void rates(const double* x, double force, double* dxdt) const;
  const Eigen::MatrixXd& matrix() const { return rates_; }
  const Eigen::VectorXd& push() const { return push_; }

  /// Unloaded and still while the far end moves with `velocity`; or moving with it under a force of
  /// 1, where springs hold that.
  Eigen::VectorXd at_rest(double velocity) const;
  const Eigen::VectorXd& dragged() const { return dragged_; }

  /// Typical size of each entry: 1 for forces, velocities that move them as much.
  std::vector<double> scales(double velocity) const;
  /// Roughly, of relaxation and of all motion; the latter with a damper and a spring at the end.
  double slowest_rate() const { return slowest_; }
  double fastest_rate(double damper, double spring) const;

 private:
  std::size_t masses_ = 0;
  Eigen::MatrixXd rates_;
  Eigen::VectorXd push_, together_, dragged_;
  Eigen::RowVectorXd port_;
  double slowest_ = 1;
};

}  // namespace vcrit::simulation::methods
