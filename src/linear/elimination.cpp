#include "linear/elimination.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <complex>

namespace vcrit::linear {

template <class Number>
Lu<Number>::Lu(const Matrix<Number>& a)
    : factors_(std::make_shared<Eigen::PartialPivLU<Matrix<Number>>>(a)) {}

template <class Number>
Vector<Number> Lu<Number>::solve(const Vector<Number>& right) const {
  return factors_->solve(right);
}

template <class Number>
Matrix<Number> Lu<Number>::solve(const Matrix<Number>& right) const {
  return factors_->solve(right);
}

template <class Number>
Matrix<Number> Lu<Number>::inverse() const {
  return factors_->inverse();
}

template <class Number>
Vector<Number> solve_fully_pivoted(const Matrix<Number>& a, const Vector<Number>& right) {
  return a.fullPivLu().solve(right);
}

Cholesky::Cholesky(const Matrix<long double>& a)
    : factors_(std::make_shared<Eigen::LLT<Matrix<long double>, Eigen::Lower>>(a)) {}

Matrix<long double> Cholesky::lower() const { return factors_->matrixL(); }

Vector<long double> Cholesky::solve(const Vector<long double>& right) const {
  return factors_->solve(right);
}

Matrix<long double> Cholesky::solve_lower(const Matrix<long double>& right) const {
  return factors_->matrixL().solve(right);
}

Ldlt::Ldlt(const Matrix<long double>& a)
    : factors_(std::make_shared<Eigen::LDLT<Matrix<long double>, Eigen::Lower>>(a)) {}

Vector<long double> Ldlt::solve(const Vector<long double>& right) const {
  return factors_->solve(right);
}

Matrix<long double> Ldlt::shapes() const {
  return factors_->transpositionsP().transpose() * Matrix<long double>(factors_->matrixL());
}

Vector<long double> Ldlt::diagonal() const { return factors_->vectorD(); }

// For each type of number what is asked for, as all of a class would take twice as long to compile.
using Complex = std::complex<double>;
using WideComplex = std::complex<long double>;

template Lu<double>::Lu(const Matrix<double>&);
template Vector<double> Lu<double>::solve(const Vector<double>&) const;
template Matrix<double> Lu<double>::inverse() const;
template Lu<long double>::Lu(const Matrix<long double>&);
template Matrix<long double> Lu<long double>::solve(const Matrix<long double>&) const;
template Matrix<long double> Lu<long double>::inverse() const;
template Lu<Complex>::Lu(const Matrix<Complex>&);
template Vector<Complex> Lu<Complex>::solve(const Vector<Complex>&) const;
template Matrix<Complex> Lu<Complex>::inverse() const;
template Lu<WideComplex>::Lu(const Matrix<WideComplex>&);
template Vector<WideComplex> Lu<WideComplex>::solve(const Vector<WideComplex>&) const;
template Vector<long double> solve_fully_pivoted(const Matrix<long double>&,
                                                 const Vector<long double>&);
template Vector<WideComplex> solve_fully_pivoted(const Matrix<WideComplex>&,
                                                 const Vector<WideComplex>&);

}  // namespace vcrit::linear
