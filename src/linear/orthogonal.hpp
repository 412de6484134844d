// Decompositions by orthogonal transformations: QR, eigenvalues, singular values. What is held is
// behind a pointer, as in elimination.hpp.
#pragma once

#include <complex>
#include <memory>

#include "linear/matrix.hpp"

namespace vcrit::linear {

/// a = Q R of m x n, by reflections.
class Qr {
 public:
  explicit Qr(const Matrix<double>& a);
  /// The x with the least |a x - right|; a has full rank and m >= n.
  Vector<double> solve(const Vector<double>& right) const;
  /// The first n columns of Q, which span those of a.
  Matrix<double> basis() const;
  /// Q^T times a column of m numbers.
  Vector<double> turned(const Vector<double>& column) const;
  /// The first rows of R, min(m, n) x n.
  Matrix<double> upper() const;
  /// R^-1, n x n.
  Matrix<double> inverse_upper() const;

 private:
  std::shared_ptr<const Eigen::HouseholderQR<Matrix<double>>> factors_;
};

/// a P = Q R of m x n, the longest column that is left first: columns may depend on one another.
class PivotedQr {
 public:
  PivotedQr() = default;  ///< of no matrix yet
  explicit PivotedQr(const Matrix<double>& a);
  /// An x with the least |a x - right|.
  Vector<double> solve(const Vector<double>& right) const;
  /// An orthonormal basis of the columns of a, m x rank; pivots below that part of the largest are
  /// rounding.
  Matrix<double> range(double rank_cut) const;

 private:
  std::shared_ptr<const Eigen::ColPivHouseholderQR<Matrix<double>>> factors_;
};

/// Of a symmetric matrix: eigenvalues, the least first, and orthonormal vectors as columns.
template <class Number>
struct SymmetricEigen {
  Vector<Number> values;
  Matrix<Number> vectors;
  bool converged;
};
SymmetricEigen<long double> symmetric_eigen(const Matrix<long double>& a);
/// The same, rounded: Eigen's solver for doubles would be compiled beside it for nothing.
SymmetricEigen<double> symmetric_eigen(const Matrix<double>& a);

/// Of any square matrix: eigenvalues, pairs side by side, and a column for each: of a real one its
/// vector, of a pair the real part and then the imaginary one.
struct GeneralEigen {
  Vector<std::complex<long double>> values;
  Matrix<long double> shapes;
  bool converged;
};
GeneralEigen general_eigen(const Matrix<long double>& a);
/// The eigenvalues alone.
Vector<std::complex<long double>> eigenvalues(const Matrix<long double>& a);

/// a = U diag(sizes) V^T of a square a, the largest first; sizes are NaN where none were found.
struct SingularValues {
  Matrix<double> u;
  Vector<double> sizes;
  Matrix<double> v;
};
SingularValues singular_values(const Matrix<double>& a);

}  // namespace vcrit::linear
