// Nonnegative least squares by the active set method of Lawson and Hanson, Solving Least Squares
// Problems (1974), chapter 23, with a QR factorisation of the free columns in each step.
#pragma once

#include <Eigen/Core>

namespace vcrit::fit {

/// The x >= 0 with the least |a x - b|. a: m x n, any m and n; columns may depend on one another.
Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

}  // namespace vcrit::fit
