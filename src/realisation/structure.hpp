// A drive as a structure that is passive by its form: masses 1 on coordinates q and one coordinate
// y without mass, where springs and dampers hold both,
//   R_d(s) = b^T (M s^2 + C s + K)^-1 b,  M = diag(0, 1, ..), b = (alpha, phi),
//   C = diag(tau, L L^T),  K = [1 h^T; h diag(w^2)].
// With h = 0 that is alpha^2/(1 + tau s) + phi^T (s^2 + L L^T s + W^2)^-1 phi: a spring and a
// damper side by side in series with modes whose damping is full. Every drive of springs, dampers
// and masses whose end has no mass and whose dampers reach that end is one of these: y is the
// coordinate that the dampers do not couple to q. K >= 0 is |h/w| < 1: h = w z/sqrt(1 + |z|^2).
#pragma once

#include <Eigen/Core>
#include <complex>

#include "realisation/rows.hpp"

namespace vcrit::realisation {

/// Which of the parameters there are.
enum class Damping {
  modal,    ///< L diagonal, z = 0
  full,     ///< L lower triangular, z = 0
  coupled,  ///< and z
};

struct StructureShape {
  Eigen::Index modes = 0;
  Damping damping = Damping::modal;

  Eigen::Index damping_parameters() const {
    return damping == Damping::modal ? modes : modes * (modes + 1) / 2;
  }
  Eigen::Index parameters() const {
    return 2 + 2 * modes + damping_parameters() + (damping == Damping::coupled ? modes : 0);
  }
  friend bool operator==(const StructureShape&, const StructureShape&) = default;
};

/// In the units of Rows.
struct Structure {
  double alpha = 0, tau = 0;
  Eigen::VectorXd phi, frequency;  ///< w
  Eigen::MatrixXd factor;          ///< L
  Eigen::VectorXd lean;            ///< z

  Eigen::Index modes() const { return phi.size(); }
  Eigen::VectorXd coupling() const;  ///< h
  Eigen::VectorXd reach() const;     ///< b
  Eigen::MatrixXd damping_matrix() const, stiffness_matrix() const;
  std::complex<double> response(double omega) const;
  double static_compliance() const;
};

/// One mode alone, R = share/(s^2 + 2 damping w s + w^2).
struct Mode {
  double frequency = 0, damping = 0, share = 0;  ///< w, part of critical, phi^2

  std::complex<double> response(double omega) const;
};

/// The sum of both, in the same units.
Structure plus_mode(const Structure& structure, const Mode& mode);

/// alpha, log tau, phi, log w, L by columns, z: as the fit moves them.
Structure structure_of(const StructureShape& shape, const Eigen::VectorXd& parameters);
Eigen::VectorXd parameters_of(const StructureShape& shape, const Structure& structure);

/// Keeps frequencies and tau where the rows can tell anything of them.
void keep_in_reach(const StructureShape& shape, const Rows& rows, Eigen::VectorXd& parameters);

/// (R(i omega) - R_i) weight_i, real parts first; with `slope`, 2 rows x parameters, its
/// derivatives.
void residuals(const StructureShape& shape, const Rows& rows, const Eigen::VectorXd& parameters,
               Eigen::VectorXd& residual, Eigen::MatrixXd* slope);

}  // namespace vcrit::realisation
