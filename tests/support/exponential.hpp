// e^A of a matrix. Eigen's takes the compiler five seconds.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace vcrit::test {

using WideMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

/// By Taylor's series of A/2^n, whose norm is below 1, and n squares.
inline WideMatrix exponential(const WideMatrix& a) {
  int squares = 0;
  std::frexp(a.cwiseAbs().colwise().sum().maxCoeff(), &squares);
  const WideMatrix part = a / std::ldexp(1.0L, std::max(squares, 0));
  WideMatrix term = WideMatrix::Identity(a.rows(), a.cols()), sum = term;
  for (int k = 1; k <= 25; ++k) {  // 1/25! is 6e-26
    term = (term.lazyProduct(part) / k).eval();
    sum += term;
  }
  for (; squares > 0; --squares) sum = sum.lazyProduct(sum).eval();
  return sum;
}

}  // namespace vcrit::test
