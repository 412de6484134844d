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
  explicit Qr(const DenseMatrix<double>& a);
  /// The x with the least |a x - right|; a has full rank and m >= n.
  DenseVector<double> solve(const DenseVector<double>& right) const;
  /// The first n columns of Q, which span those of a.
  DenseMatrix<double> basis() const;
  /// Q^T times a column of m numbers.
  DenseVector<double> turned(const DenseVector<double>& column) const;
  /// The first rows of R, min(m, n) x n.
  DenseMatrix<double> upper() const;
  /// R^-1, n x n.
  DenseMatrix<double> inverse_upper() const;

 private:
  std::shared_ptr<const Eigen::HouseholderQR<DenseMatrix<double>>> factors_;
};

/// a P = Q R of m x n, the longest column that is left first: columns may depend on one another.
class PivotedQr {
 public:
  PivotedQr() = default;  ///< of no matrix yet
  explicit PivotedQr(const DenseMatrix<double>& a);
  /// An x with the least |a x - right|.
  DenseVector<double> solve(const DenseVector<double>& right) const;
  /// An orthonormal basis of the columns of a, m x rank; pivots below that part of the largest are
  /// rounding.
  DenseMatrix<double> range(double rank_cut) const;

 private:
  std::shared_ptr<const Eigen::ColPivHouseholderQR<DenseMatrix<double>>> factors_;
};

/// Of a symmetric matrix: eigenvalues, the least first, and orthonormal vectors as columns.
template <class Number>
struct SymmetricEigen {
  DenseVector<Number> values;
  DenseMatrix<Number> vectors;
  bool converged;
};
SymmetricEigen<long double> symmetric_eigen(const DenseMatrix<long double>& a);
/// The same, rounded: Eigen's solver for doubles would be compiled beside it for nothing.
SymmetricEigen<double> symmetric_eigen(const DenseMatrix<double>& a);

/// Of any square matrix: eigenvalues, pairs side by side, and a column for each: of a real one its
/// vector, of a pair the real part and then the imaginary one.
struct GeneralEigen {
  DenseVector<std::complex<long double>> values;
  DenseMatrix<long double> shapes;
  bool converged;
};
GeneralEigen general_eigen(const DenseMatrix<long double>& a);
/// The eigenvalues alone.
DenseVector<std::complex<long double>> eigenvalues(const DenseMatrix<long double>& a);

/// a = U diag(sizes) V^T of a square a, the largest first; sizes are NaN where none were found.
struct SingularValues {
  DenseMatrix<double> u;
  DenseVector<double> sizes;
  DenseMatrix<double> v;
};
SingularValues singular_values(const DenseMatrix<double>& a);

}  // namespace vcrit::linear
