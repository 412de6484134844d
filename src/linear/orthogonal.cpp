#include "linear/orthogonal.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>

namespace vcrit::linear {

Qr::Qr(const Matrix<double>& a)
    : factors_(std::make_shared<Eigen::HouseholderQR<Matrix<double>>>(a)) {}

Vector<double> Qr::solve(const Vector<double>& right) const { return factors_->solve(right); }

Matrix<double> Qr::basis() const {
  const auto& packed = factors_->matrixQR();
  return factors_->householderQ() * Matrix<double>::Identity(packed.rows(), packed.cols());
}

Vector<double> Qr::turned(const Vector<double>& column) const {
  return factors_->householderQ().adjoint() * column;
}

Matrix<double> Qr::upper() const {
  const auto& packed = factors_->matrixQR();
  return packed.topRows(std::min(packed.rows(), packed.cols()))
      .template triangularView<Eigen::Upper>();
}

Matrix<double> Qr::inverse_upper() const {
  const Eigen::Index n = factors_->matrixQR().cols();
  return factors_->matrixQR().topRows(n).template triangularView<Eigen::Upper>().solve(
      Matrix<double>::Identity(n, n));
}

PivotedQr::PivotedQr(const Matrix<double>& a)
    : factors_(std::make_shared<Eigen::ColPivHouseholderQR<Matrix<double>>>(a)) {}

Vector<double> PivotedQr::solve(const Vector<double>& right) const {
  return factors_->solve(right);
}

Matrix<double> PivotedQr::range(double rank_cut) const {
  Eigen::ColPivHouseholderQR<Matrix<double>> factors(*factors_);
  factors.setThreshold(rank_cut);
  return factors.householderQ() * Matrix<double>::Identity(factors.rows(), factors.rank());
}

template <class Number>
SymmetricEigen<Number> symmetric_eigen(const Matrix<Number>& a) {
  const Eigen::SelfAdjointEigenSolver<Matrix<Number>> found(a);
  return {found.eigenvalues(), found.eigenvectors(), found.info() == Eigen::Success};
}

template <class Number>
GeneralEigen<Number> general_eigen(const Matrix<Number>& a) {
  const Eigen::EigenSolver<Matrix<Number>> found(a);
  if (found.info() != Eigen::Success) return {{}, {}, false};
  return {found.eigenvalues(), found.pseudoEigenvectors(), true};
}

template <class Number>
Vector<std::complex<Number>> eigenvalues(const Matrix<Number>& a) {
  return Eigen::EigenSolver<Matrix<Number>>(a, false).eigenvalues();
}

SingularValues singular_values(const Matrix<double>& a) {
  const Eigen::JacobiSVD<Matrix<double>> found(a, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return {found.matrixU(), found.singularValues(), found.matrixV()};
}

template SymmetricEigen<double> symmetric_eigen(const Matrix<double>&);
template SymmetricEigen<long double> symmetric_eigen(const Matrix<long double>&);
template GeneralEigen<long double> general_eigen(const Matrix<long double>&);
template Vector<std::complex<double>> eigenvalues(const Matrix<double>&);
template Vector<std::complex<long double>> eigenvalues(const Matrix<long double>&);

}  // namespace vcrit::linear
