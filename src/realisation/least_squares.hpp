// Least squares by Levenberg and Marquardt, as More (1978) scales it and Nielsen (1999) moves the
// damping: each step solves with a QR factorisation, never with the normal equations, whose
// condition would be squared.
#pragma once

#include <Eigen/Core>
#include <functional>

namespace vcrit::realisation {

struct LeastSquares {
  /// The residual at these parameters and, where it is not null, its derivatives.
  std::function<void(const Eigen::VectorXd&, Eigen::VectorXd&, Eigen::MatrixXd*)> residual;
  std::function<void(Eigen::VectorXd&)> keep_in_reach;
};

struct Minimum {
  Eigen::VectorXd parameters;
  double sum = 0;  ///< of squares; infinite where the start has no value
};

/// At most `steps` factorisations; ends before that where the sum no longer falls, or is at most
/// `enough`.
Minimum minimise(const LeastSquares& problem, Eigen::VectorXd start, int steps, double enough = 0);

}  // namespace vcrit::realisation
