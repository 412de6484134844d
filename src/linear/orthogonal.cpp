#include "linear/orthogonal.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <limits>

#include "base/gsl_errors.hpp"

namespace vcrit::linear {

Qr::Qr(const DenseMatrix<double>& a)
    : factors_(std::make_shared<Eigen::HouseholderQR<DenseMatrix<double>>>(a)) {}

DenseVector<double> Qr::solve(const DenseVector<double>& right) const {
  return factors_->solve(right);
}

DenseMatrix<double> Qr::basis() const {
  const auto& packed = factors_->matrixQR();
  return factors_->householderQ() * DenseMatrix<double>::Identity(packed.rows(), packed.cols());
}

DenseVector<double> Qr::turned(const DenseVector<double>& column) const {
  return factors_->householderQ().adjoint() * column;
}

DenseMatrix<double> Qr::upper() const {
  const auto& packed = factors_->matrixQR();
  return packed.topRows(std::min(packed.rows(), packed.cols()))
      .template triangularView<Eigen::Upper>();
}

DenseMatrix<double> Qr::inverse_upper() const {
  const Eigen::Index n = factors_->matrixQR().cols();
  return factors_->matrixQR().topRows(n).template triangularView<Eigen::Upper>().solve(
      DenseMatrix<double>::Identity(n, n));
}

PivotedQr::PivotedQr(const DenseMatrix<double>& a)
    : factors_(std::make_shared<Eigen::ColPivHouseholderQR<DenseMatrix<double>>>(a)) {}

DenseVector<double> PivotedQr::solve(const DenseVector<double>& right) const {
  return factors_->solve(right);
}

DenseMatrix<double> PivotedQr::range(double rank_cut) const {
  Eigen::ColPivHouseholderQR<DenseMatrix<double>> factors(*factors_);
  factors.setThreshold(rank_cut);
  return factors.householderQ() * DenseMatrix<double>::Identity(factors.rows(), factors.rank());
}

SymmetricEigen<long double> symmetric_eigen(const DenseMatrix<long double>& a) {
  const Eigen::SelfAdjointEigenSolver<DenseMatrix<long double>> found(a);
  return {found.eigenvalues(), found.eigenvectors(), found.info() == Eigen::Success};
}

SymmetricEigen<double> symmetric_eigen(const DenseMatrix<double>& a) {
  const SymmetricEigen<long double> found =
      symmetric_eigen(DenseMatrix<long double>(a.cast<long double>()));
  return {found.values.cast<double>(), found.vectors.cast<double>(), found.converged};
}

GeneralEigen general_eigen(const DenseMatrix<long double>& a) {
  const Eigen::EigenSolver<DenseMatrix<long double>> found(a);
  if (found.info() != Eigen::Success) return {{}, {}, false};
  return {found.eigenvalues(), found.pseudoEigenvectors(), true};
}

DenseVector<std::complex<long double>> eigenvalues(const DenseMatrix<long double>& a) {
  return Eigen::EigenSolver<DenseMatrix<long double>>(a, false).eigenvalues();
}

// By GSL, which is compiled already.
SingularValues singular_values(const DenseMatrix<double>& a) {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const auto n = static_cast<std::size_t>(a.cols());
  Rows u = a, v(a.cols(), a.cols());
  DenseVector<double> sizes(a.cols());
  gsl_matrix_view u_view = gsl_matrix_view_array(u.data(), n, n);
  gsl_matrix_view v_view = gsl_matrix_view_array(v.data(), n, n);
  gsl_vector_view sizes_view = gsl_vector_view_array(sizes.data(), n);
  const GslErrorsOff off;
  if (gsl_linalg_SV_decomp_jacobi(&u_view.matrix, &v_view.matrix, &sizes_view.vector) !=
      GSL_SUCCESS)
    sizes.setConstant(std::numeric_limits<double>::quiet_NaN());
  return {u, sizes, v};
}

}  // namespace vcrit::linear
