// Exact steps of a linear system Z' = M Z in many digits: exp(M h) for h = 2 pi/2^k, k =
// 0..deepest, by scaling and squaring, and integrals of quadratic forms over them.
#pragma once

#include <Eigen/Dense>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <vector>

namespace reference {

template <unsigned digits>
using Digits = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<digits>,
                                             boost::multiprecision::et_off>;
template <class Real>
using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
template <class Real>
using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
template <class Real>
using Row = Eigen::Matrix<Real, 1, Eigen::Dynamic>;

template <class Real>
Real pi() {
  return acos(Real(-1));
}

template <class Real>
Real norm(const Matrix<Real>& m) {
  return m.cwiseAbs().rowwise().sum().maxCoeff();
}

/// exp(M h) and, for quadratic forms Q, the integrals of exp(M s)^T Q exp(M s) over 0..h.
template <class Real>
struct Step {
  Matrix<Real> move;
  std::vector<Matrix<Real>> forms;

  /// This step and then that one.
  Step then(const Step& next) const {
    Step both{next.move * move, {}};
    for (std::size_t i = 0; i < forms.size(); ++i)
      both.forms.push_back(forms[i] + move.transpose() * next.forms[i] * move);
    return both;
  }
};

/// By Taylor series; norm(M) h well below 1.
template <class Real>
Step<Real> short_step(const Matrix<Real>& m, const std::vector<Matrix<Real>>& forms,
                      const Real& h) {
  Matrix<Real> term = Matrix<Real>::Identity(m.rows(), m.cols());
  Step<Real> step{term, {}};
  const Real tiny = std::numeric_limits<Real>::epsilon() * Real("1e-10");
  int terms = 0;
  for (Real size = 1; size > tiny; size *= norm<Real>(m) * h) ++terms;
  for (int k = 1; k < terms; ++k) {
    term = Matrix<Real>(m * term) * (h / k);
    step.move += term;
  }
  for (const Matrix<Real>& form : forms) {
    Matrix<Real> part = form * h, sum = part;
    for (int k = 2; k < terms; ++k) {
      part = Matrix<Real>(m.transpose() * part + part * m) * (h / k);
      sum += part;
    }
    step.forms.push_back(sum);
  }
  return step;
}

template <class Real>
class Steps {
 public:
  /// Down to steps of 2^-50 periods and 2^-16 of the system's fastest time.
  Steps(Matrix<Real> m, std::vector<Matrix<Real>> forms)
      : m_(std::move(m)), forms_(std::move(forms)), size_(norm<Real>(m_)) {
    deepest_ = 50;
    while (length(deepest_) * size_ > Real("1.5e-5")) ++deepest_;
    steps_.resize(static_cast<std::size_t>(deepest_) + 1);
    steps_.back() = short_step<Real>(m_, forms_, length(deepest_));
    for (std::size_t k = steps_.size() - 1; k-- > 0;) steps_[k] = steps_[k + 1].then(steps_[k + 1]);
  }

  const Matrix<Real>& matrix() const { return m_; }
  int deepest() const { return deepest_; }
  static Real length(int k) { return ldexp(2 * pi<Real>(), -k); }
  const Matrix<Real>& move(int k) const { return steps_[static_cast<std::size_t>(k)].move; }

  /// Over any duration from 0 on.
  Step<Real> over(Real duration) const {
    Step<Real> result{Matrix<Real>::Identity(m_.rows(), m_.cols()), {}};
    for (const Matrix<Real>& form : forms_)
      result.forms.push_back(Matrix<Real>::Zero(form.rows(), form.cols()));
    for (int k = 0; k <= deepest_; ++k)
      while (duration >= length(k)) {
        result = result.then(steps_[static_cast<std::size_t>(k)]);
        duration -= length(k);
      }
    return result.then(short_step<Real>(m_, forms_, duration));
  }

  /// Taylor coefficients of row * Z(t); norm(M) t well below 1.
  std::vector<Real> series(const Row<Real>& row, Vector<Real> z) const {
    std::vector<Real> terms;
    const int count = std::numeric_limits<Real>::digits / 15;
    for (int k = 1; k <= count; ++k) {
      terms.push_back(row.dot(z));
      z = m_ * z / Real(k);
    }
    return terms;
  }

 private:
  Matrix<Real> m_;
  std::vector<Matrix<Real>> forms_;
  Real size_;
  int deepest_;
  std::vector<Step<Real>> steps_;
};

}  // namespace reference
