// Decompositions by elimination: LU, Cholesky, L D L^T. A type of number has those members that
// somebody asks for (the end of elimination.cpp). What is held is behind a pointer, so that Eigen's
// types are compiled nowhere else; copies share it.
#pragma once

#include <memory>

#include "linear/matrix.hpp"

namespace vcrit::linear {

/// P a = L U of a square a, with pivots of a column. Of a singular a it solves to numbers that are
/// not finite, as a structure in resonance moves, or to none that mean anything.
template <class Number>
class Lu {
 public:
  Lu() = default;  ///< of no matrix yet
  explicit Lu(const Matrix<Number>& a);
  Vector<Number> solve(const Vector<Number>& right) const;
  Matrix<Number> solve(const Matrix<Number>& right) const;
  Matrix<Number> inverse() const;

 private:
  std::shared_ptr<const Eigen::PartialPivLU<Matrix<Number>>> factors_;
};

/// The x with a x = right, with pivots of the whole matrix: of a singular a, one of them.
template <class Number>
Vector<Number> solve_fully_pivoted(const Matrix<Number>& a, const Vector<Number>& right);

/// a = L L^T of a positive definite a. Of another one L means nothing.
class Cholesky {
 public:
  explicit Cholesky(const Matrix<long double>& a);
  Matrix<long double> lower() const;
  Vector<long double> solve(const Vector<long double>& right) const;
  /// L^-1 right.
  Matrix<long double> solve_lower(const Matrix<long double>& right) const;

 private:
  std::shared_ptr<const Eigen::LLT<Matrix<long double>, Eigen::Lower>> factors_;
};

/// P a P^T = L D L^T of a symmetric a without negative eigenvalues.
class Ldlt {
 public:
  explicit Ldlt(const Matrix<long double>& a);
  Vector<long double> solve(const Vector<long double>& right) const;
  Matrix<long double> shapes() const;    ///< P^T L: a = shapes D shapes^T
  Vector<long double> diagonal() const;  ///< of D

 private:
  std::shared_ptr<const Eigen::LDLT<Matrix<long double>, Eigen::Lower>> factors_;
};

}  // namespace vcrit::linear
