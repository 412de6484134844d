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
  explicit Lu(const DenseMatrix<Number>& a);
  DenseVector<Number> solve(const DenseVector<Number>& right) const;
  DenseMatrix<Number> solve(const DenseMatrix<Number>& right) const;
  DenseMatrix<Number> inverse() const;

 private:
  std::shared_ptr<const Eigen::PartialPivLU<DenseMatrix<Number>>> factors_;
};

/// The x with a x = right, with pivots of the whole matrix: of a singular a, one of them.
template <class Number>
DenseVector<Number> solve_fully_pivoted(const DenseMatrix<Number>& a,
                                        const DenseVector<Number>& right);

/// a = L L^T of a positive definite a. Of another one L means nothing.
class Cholesky {
 public:
  explicit Cholesky(const DenseMatrix<long double>& a);
  DenseMatrix<long double> lower() const;
  DenseVector<long double> solve(const DenseVector<long double>& right) const;
  /// L^-1 right.
  DenseMatrix<long double> solve_lower(const DenseMatrix<long double>& right) const;

 private:
  std::shared_ptr<const Eigen::LLT<DenseMatrix<long double>, Eigen::Lower>> factors_;
};

/// P a P^T = L D L^T of a symmetric a without negative eigenvalues.
class Ldlt {
 public:
  explicit Ldlt(const DenseMatrix<long double>& a);
  DenseVector<long double> solve(const DenseVector<long double>& right) const;
  DenseMatrix<long double> shapes() const;    ///< P^T L: a = shapes D shapes^T
  DenseVector<long double> diagonal() const;  ///< of D

 private:
  std::shared_ptr<const Eigen::LDLT<DenseMatrix<long double>, Eigen::Lower>> factors_;
};

}  // namespace vcrit::linear
