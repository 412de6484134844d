// Small complex systems: solutions that are known, where pivots have to be exchanged and where not.
#include "indenter/shifted_lu.hpp"

#include <boost/test/unit_test.hpp>
#include <limits>

BOOST_AUTO_TEST_SUITE(test_shifted_lu)

BOOST_AUTO_TEST_CASE(solutions_that_are_known_are_found) {
  using vcrit::indenter::ShiftedLu;
  // Neither is 1 - s J symmetric nor are its pivots on the diagonal: the first one is 0.
  const Eigen::MatrixXd j{{1, 2, 0, 3}, {-4, 0.5, 2, 0}, {0, 3, -1, 0.25}, {5, 0, 1, -2}};
  ShiftedLu factors;
  for (const ShiftedLu::Complex s : {ShiftedLu::Complex(1, 0), ShiftedLu::Complex(0.3, -2)}) {
    const Eigen::VectorXcd wanted{{{1, 2}, {0, -3}, {0.5, 0}, {-2, 0.25}}};
    const Eigen::VectorXcd right = wanted - s * (j * wanted);
    factors.factorise(j, s);
    Eigen::VectorXcd found;
    factors.solve(right, found);
    // Rounding of four unknowns, times a condition number below 50.
    constexpr double rounding = 4 * 50 * std::numeric_limits<double>::epsilon();
    BOOST_TEST((found - wanted).norm() <= rounding * wanted.norm());
  }
}

BOOST_AUTO_TEST_SUITE_END()
