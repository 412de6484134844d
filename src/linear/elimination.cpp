#include "linear/elimination.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <complex>

namespace vcrit::linear {

template <class Number>
Lu<Number>::Lu(const DenseMatrix<Number>& a)
    : factors_(std::make_shared<Eigen::PartialPivLU<DenseMatrix<Number>>>(a)) {}

template <class Number>
DenseVector<Number> Lu<Number>::solve(const DenseVector<Number>& right) const {
  return factors_->solve(right);
}

template <class Number>
DenseMatrix<Number> Lu<Number>::solve(const DenseMatrix<Number>& right) const {
  return factors_->solve(right);
}

template <class Number>
DenseMatrix<Number> Lu<Number>::inverse() const {
  return factors_->inverse();
}

template <class Number>
DenseVector<Number> solve_fully_pivoted(const DenseMatrix<Number>& a,
                                        const DenseVector<Number>& right) {
  return a.fullPivLu().solve(right);
}

Cholesky::Cholesky(const DenseMatrix<long double>& a)
    : factors_(std::make_shared<Eigen::LLT<DenseMatrix<long double>, Eigen::Lower>>(a)) {}

DenseMatrix<long double> Cholesky::lower() const { return factors_->matrixL(); }

DenseVector<long double> Cholesky::solve(const DenseVector<long double>& right) const {
  return factors_->solve(right);
}

DenseMatrix<long double> Cholesky::solve_lower(const DenseMatrix<long double>& right) const {
  return factors_->matrixL().solve(right);
}

Ldlt::Ldlt(const DenseMatrix<long double>& a)
    : factors_(std::make_shared<Eigen::LDLT<DenseMatrix<long double>, Eigen::Lower>>(a)) {}

DenseVector<long double> Ldlt::solve(const DenseVector<long double>& right) const {
  return factors_->solve(right);
}

DenseMatrix<long double> Ldlt::shapes() const {
  return factors_->transpositionsP().transpose() * DenseMatrix<long double>(factors_->matrixL());
}

DenseVector<long double> Ldlt::diagonal() const { return factors_->vectorD(); }

// For each type of number what is asked for, as all of a class would take twice as long to compile.
using Complex = std::complex<double>;
using WideComplex = std::complex<long double>;

template Lu<double>::Lu(const DenseMatrix<double>&);
template DenseVector<double> Lu<double>::solve(const DenseVector<double>&) const;
template DenseMatrix<double> Lu<double>::inverse() const;
template Lu<long double>::Lu(const DenseMatrix<long double>&);
template DenseMatrix<long double> Lu<long double>::solve(const DenseMatrix<long double>&) const;
template DenseMatrix<long double> Lu<long double>::inverse() const;
template Lu<Complex>::Lu(const DenseMatrix<Complex>&);
template DenseVector<Complex> Lu<Complex>::solve(const DenseVector<Complex>&) const;
template DenseMatrix<Complex> Lu<Complex>::inverse() const;
template Lu<WideComplex>::Lu(const DenseMatrix<WideComplex>&);
template DenseVector<WideComplex> Lu<WideComplex>::solve(const DenseVector<WideComplex>&) const;
template DenseVector<long double> solve_fully_pivoted(const DenseMatrix<long double>&,
                                                      const DenseVector<long double>&);
template DenseVector<WideComplex> solve_fully_pivoted(const DenseMatrix<WideComplex>&,
                                                      const DenseVector<WideComplex>&);

}  // namespace vcrit::linear
