// Singular values against 60 digits of mpmath, and the product of the three factors against the
// matrix. Each rotation errs by some roundings of the largest: 64 of them are allowed, for at most
// three columns.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "linear/orthogonal.hpp"

BOOST_AUTO_TEST_SUITE(test_singular_values)

using namespace vcrit::linear;

namespace {

constexpr double allowed = 64 * std::numeric_limits<double>::epsilon();

struct Example {
  DenseMatrix<double> matrix;
  std::vector<double> sizes;
};

std::vector<Example> examples() {
  return {{DenseMatrix<double>{{-3}}, {3}},
          {DenseMatrix<double>{{1, 1}, {0, 1e-12}},
           {1.414213562373095048801689, 7.071067811865475e-13}},
          {DenseMatrix<double>{{2, 0, 1}, {1, 1e-9, 0}, {0, 0, 1e-18}},
           {2.414213562373095048832019, 0.4142135623730950498320188, 2.0000000000000003e-27}},
          // Two rows alike, and a column of zeros: of rank 1.
          {DenseMatrix<double>{{3, 0, 4}, {3, 0, 4}, {0, 0, 0}}, {7.0710678118654752440, 0, 0}}};
}

}  // namespace

BOOST_AUTO_TEST_CASE(are_those_of_many_digits) {
  for (const auto& [matrix, sizes] : examples()) {
    const SingularValues found = singular_values(matrix);
    const double largest = sizes.front();
    for (Eigen::Index i = 0; i < matrix.cols(); ++i)
      BOOST_TEST(std::abs(found.sizes(i) - sizes[static_cast<std::size_t>(i)]) <=
                 allowed * largest);
    const DenseMatrix<double> product = found.u * found.sizes.asDiagonal() * found.v.transpose();
    BOOST_TEST((product - matrix).cwiseAbs().maxCoeff() <= allowed * largest);
  }
}

BOOST_AUTO_TEST_CASE(there_are_none_of_what_is_no_number) {
  DenseMatrix<double> matrix = DenseMatrix<double>::Identity(3, 3);
  matrix(1, 2) = std::numeric_limits<double>::quiet_NaN();
  BOOST_TEST(singular_values(matrix).sizes.hasNaN());
}

BOOST_AUTO_TEST_SUITE_END()
