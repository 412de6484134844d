// Levenberg and Marquardt on problems whose minimum is known.
#include "realisation/least_squares.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

BOOST_AUTO_TEST_SUITE(test_least_squares)

namespace {

using namespace vcrit::realisation;
using Eigen::MatrixXd;
using Eigen::VectorXd;

const auto anywhere = [](VectorXd&) {};

}  // namespace

BOOST_AUTO_TEST_CASE(the_valley_of_rosenbrock_is_followed_to_its_end) {
  const LeastSquares valley{[](const VectorXd& x, VectorXd& residual, MatrixXd* slope) {
                              residual = Eigen::Vector2d(10 * (x[1] - x[0] * x[0]), 1 - x[0]);
                              if (slope) {
                                slope->resize(2, 2);
                                *slope << -20 * x[0], 10, -1, 0;
                              }
                            },
                            anywhere};
  const Minimum found = minimise(valley, Eigen::Vector2d(-1.2, 1), 200);
  // Steps that gain less than 1e-5 of the sum end it, and the sum is 0 there: quadratic to
  // rounding.
  BOOST_TEST(std::abs(found.parameters[0] - 1) < 1e-10);
  BOOST_TEST(found.sum < 1e-20);
}

BOOST_AUTO_TEST_CASE(columns_that_depend_on_one_another_do_no_harm) {
  const LeastSquares flat{[](const VectorXd& x, VectorXd& residual, MatrixXd* slope) {
                            residual = VectorXd::Constant(3, x[0] + x[1] - 2);
                            residual[2] += 3;
                            if (slope) *slope = MatrixXd::Ones(3, 2);
                          },
                          anywhere};
  // Least of 2 r^2 + (r + 3)^2: r = -1, 6.
  const Minimum found = minimise(flat, Eigen::Vector2d(5, 7), 100);
  BOOST_TEST(std::abs(found.sum - 6) < 1e-8);
}

// One that enters by its square has no slope at 0, and by its own scale a step without bound.
BOOST_AUTO_TEST_CASE(a_parameter_without_a_slope_does_not_hold_up_the_other) {
  const LeastSquares square{[](const VectorXd& x, VectorXd& residual, MatrixXd* slope) {
                              residual =
                                  Eigen::Vector2d(std::exp(x[0]) - 5, 1e3 * x[1] * x[1] - 0.01);
                              if (slope) {
                                slope->resize(2, 2);
                                *slope << std::exp(x[0]), 0, 0, 2e3 * x[1];
                              }
                            },
                            anywhere};
  const Minimum found = minimise(square, Eigen::Vector2d(0, 1e-20), 12);
  // Twelve steps, damped at first, are most of the way; rejected ones leave all of it, 1.6.
  BOOST_TEST(std::abs(found.parameters[0] - std::log(5)) < 0.8);
}

BOOST_AUTO_TEST_CASE(what_has_no_value_ends_at_once) {
  const LeastSquares nowhere{[](const VectorXd&, VectorXd& residual, MatrixXd* slope) {
                               residual = VectorXd::Constant(1, std::nan(""));
                               if (slope) *slope = MatrixXd::Ones(1, 1);
                             },
                             anywhere};
  BOOST_TEST(std::isinf(minimise(nowhere, VectorXd::Ones(1), 100).sum));
}

BOOST_AUTO_TEST_SUITE_END()
