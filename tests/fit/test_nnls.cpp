// Nonnegative least squares against all subsets of columns, and by the conditions of an optimum.
#include "fit/nnls.hpp"

#include <Eigen/LU>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_nnls)

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using vcrit::fit::nonnegative_least_squares;

MatrixXd drawn(std::mt19937_64& engine, Index rows, Index columns) {
  MatrixXd result(rows, columns);
  for (Index i = 0; i < rows; ++i)
    for (Index j = 0; j < columns; ++j)
      result(i, j) = static_cast<double>(engine()) / 9223372036854775808.0 - 1;
  return result;
}

// The least residual over all subsets whose own least squares are nonnegative, which an optimum is
// among; by normal equations, where the code under test has a QR factorisation.
double least_by_subsets(const MatrixXd& a, const VectorXd& b) {
  double least = b.norm();
  for (unsigned subset = 1; subset < 1U << a.cols(); ++subset) {
    std::vector<Index> columns;
    for (Index j = 0; j < a.cols(); ++j)
      if ((subset >> j & 1U) != 0) columns.push_back(j);
    const MatrixXd part = a(Eigen::all, columns);
    const VectorXd x = (part.transpose() * part).fullPivLu().solve(part.transpose() * b);
    if (x.minCoeff() >= 0) least = std::min(least, (part * x - b).norm());
  }
  return least;
}

BOOST_AUTO_TEST_CASE(no_subset_of_columns_does_better) {
  std::mt19937_64 engine(7);
  for (int trial = 0; trial < 300; ++trial) {
    const Index columns = 1 + trial % 8, rows = 1 + trial % 11;
    const MatrixXd a = drawn(engine, rows, columns);
    const VectorXd b = drawn(engine, rows, 1);
    const VectorXd x = nonnegative_least_squares(a, b);
    BOOST_TEST(x.minCoeff() >= 0);
    // Normal equations square the condition of these small random matrices, some 1e3: 1e-10.
    if (rows >= columns) BOOST_TEST((a * x - b).norm() <= least_by_subsets(a, b) + 1e-10);
  }
}

// At an optimum no column that is out lowers the residual, and none that is in does.
BOOST_AUTO_TEST_CASE(the_conditions_of_an_optimum_hold_for_nearly_dependent_columns) {
  // Responses x/(1 + x^2) of neighbours in a dense grid, as the fit has them.
  constexpr Index rows = 60, columns = 120;
  MatrixXd a(rows, columns);
  VectorXd b(rows);
  for (Index i = 0; i < rows; ++i) {
    const double omega = std::pow(10, -3 + 6.0 * static_cast<double>(i) / (rows - 1));
    for (Index j = 0; j < columns; ++j) {
      const double x = omega * std::pow(10, -4 + 8.0 * static_cast<double>(j) / (columns - 1));
      a(i, j) = x / (1 + x * x);
    }
    b[i] = std::pow(omega, 0.1) * (1 + 0.01 * std::sin(37 * static_cast<double>(i)));
  }
  const VectorXd x = nonnegative_least_squares(a, b);
  const VectorXd gradient = a.transpose() * (b - a * x);
  for (Index j = 0; j < columns; ++j) {
    // A sum of 60 products of order 1: 60 x 2^-53, a hundredfold for the solve.
    const double rounding = 1e-12 * a.col(j).norm() * b.norm();
    BOOST_TEST(x[j] >= 0);
    BOOST_TEST(gradient[j] <= rounding);
    if (x[j] > 0) BOOST_TEST(std::abs(gradient[j]) <= rounding);
  }
}

BOOST_AUTO_TEST_CASE(degenerate_ones_end) {
  const MatrixXd twice = (MatrixXd(2, 2) << 1, 1, 2, 2).finished();
  const VectorXd x = nonnegative_least_squares(twice, VectorXd(VectorXd::LinSpaced(2, 3, 6)));
  BOOST_TEST(std::abs(x.sum() - 3) < 1e-15 * 8);
  BOOST_TEST(nonnegative_least_squares(twice, -VectorXd::Ones(2)).isZero());
  BOOST_TEST(nonnegative_least_squares(MatrixXd::Zero(2, 2), VectorXd::Ones(2)).isZero());
  BOOST_TEST(nonnegative_least_squares(MatrixXd(2, 0), VectorXd::Ones(2)).size() == 0);
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()
