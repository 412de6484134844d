// Linear systems with 1 - s J of a real matrix J and a complex s, for a handful of unknowns: a step
// of collocation has four of them. linear::Lu, made for large ones, takes twice to five times as
// long there, for the same numbers up to 8 unknowns.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

namespace vcrit::indenter {

/// P (1 - s J) = L U, with pivots of a column. It can be used again without new memory.
class ShiftedLu {
 public:
  using Complex = std::complex<double>;

  void factorise(const Eigen::MatrixXd& j, Complex s);
  /// x with (1 - s J) x = right.
  void solve(const Eigen::VectorXcd& right, Eigen::VectorXcd& x) const;

 private:
  // Of finite numbers, whose squares are finite too: operators of std::complex look for others.
  static Complex product(Complex a, Complex b);
  static Complex quotient(Complex a, Complex b);
  void eliminate(Eigen::Index k);

  Eigen::MatrixXcd factors_;
  std::vector<Eigen::Index> rows_;  ///< of the right side, in the order of those of L
};

}  // namespace vcrit::indenter
