#include "indenter/shifted_lu.hpp"

#include <numeric>
#include <utility>

namespace vcrit::indenter {

ShiftedLu::Complex ShiftedLu::product(Complex a, Complex b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

ShiftedLu::Complex ShiftedLu::quotient(Complex a, Complex b) {
  const double size = b.real() * b.real() + b.imag() * b.imag();
  const Complex turned = product(a, std::conj(b));
  return {turned.real() / size, turned.imag() / size};
}

void ShiftedLu::factorise(const Eigen::MatrixXd& j, Complex s) {
  factors_.resize(j.rows(), j.cols());
  for (Eigen::Index i = 0; i < j.size(); ++i)
    factors_.data()[i] = {-s.real() * j.data()[i], -s.imag() * j.data()[i]};
  factors_.diagonal().array() += 1;
  rows_.resize(static_cast<std::size_t>(j.rows()));
  std::iota(rows_.begin(), rows_.end(), 0);
  for (Eigen::Index k = 0; k < j.rows(); ++k) eliminate(k);
}

void ShiftedLu::eliminate(Eigen::Index k) {
  const Eigen::Index n = factors_.rows();
  Eigen::Index pivot = k;
  double most = std::norm(factors_(k, k));
  for (Eigen::Index i = k + 1; i < n; ++i)
    if (const double size = std::norm(factors_(i, k)); size > most) {
      most = size;
      pivot = i;
    }
  if (most == 0) return;
  if (pivot != k) {
    factors_.row(k).swap(factors_.row(pivot));
    std::swap(rows_[static_cast<std::size_t>(k)], rows_[static_cast<std::size_t>(pivot)]);
  }
  for (Eigen::Index i = k + 1; i < n; ++i)
    factors_(i, k) = quotient(factors_(i, k), factors_(k, k));
  for (Eigen::Index c = k + 1; c < n; ++c)
    for (Eigen::Index i = k + 1; i < n; ++i)
      factors_(i, c) -= product(factors_(i, k), factors_(k, c));
}

void ShiftedLu::solve(const Eigen::VectorXcd& right, Eigen::VectorXcd& x) const {
  const Eigen::Index n = factors_.rows();
  x.resize(n);
  for (Eigen::Index i = 0; i < n; ++i) x(i) = right(rows_[static_cast<std::size_t>(i)]);
  for (Eigen::Index c = 0; c < n; ++c)
    for (Eigen::Index i = c + 1; i < n; ++i) x(i) -= product(factors_(i, c), x(c));
  for (Eigen::Index c = n - 1; c >= 0; --c) {
    if (x(c) == 0.0) continue;
    x(c) /= factors_(c, c);
    for (Eigen::Index i = 0; i < c; ++i) x(i) -= product(factors_(i, c), x(c));
  }
}

}  // namespace vcrit::indenter
