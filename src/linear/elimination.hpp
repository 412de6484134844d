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
template <class Number>
class Cholesky {
 public:
  explicit Cholesky(const Matrix<Number>& a);
  Matrix<Number> lower() const;
  Vector<Number> solve(const Vector<Number>& right) const;
  /// L^-1 right.
  Matrix<Number> solve_lower(const Matrix<Number>& right) const;

 private:
  std::shared_ptr<const Eigen::LLT<Matrix<Number>, Eigen::Lower>> factors_;
};

/// P a P^T = L D L^T of a symmetric a without negative eigenvalues.
template <class Number>
class Ldlt {
 public:
  explicit Ldlt(const Matrix<Number>& a);
  Vector<Number> solve(const Vector<Number>& right) const;
  Matrix<Number> shapes() const;    ///< P^T L: a = shapes D shapes^T
  Vector<Number> diagonal() const;  ///< of D

 private:
  std::shared_ptr<const Eigen::LDLT<Matrix<Number>, Eigen::Lower>> factors_;
};

}  // namespace vcrit::linear
