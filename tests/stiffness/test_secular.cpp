#include "stiffness/secular.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

BOOST_AUTO_TEST_SUITE(test_secular)

using namespace vcrit;

namespace {

constexpr double u = 1.1e-16;

// f = m x - c + w/(x - p) has the roots of m d^2 - (c - m p) d + w for d = x - p. With w tiny they
// are w/(c - m p) and (c - m p)/m but for a share of m w/(c - m p)^2.
void check_weak_pole(double m, double c, double p, double w, double far_pole, double far_weight) {
  const auto roots = positive_roots({m, c, {p, far_pole}, {w, far_weight}});
  BOOST_TEST_REQUIRE(roots.size() == 3U);
  const double excess = c - m * p;
  BOOST_TEST(roots[0].reference == p);
  // The far pole adds far_weight/(far_pole - p) to the excess.
  const double far = far_weight / ((far_pole - p) * excess);
  BOOST_TEST(std::abs(roots[0].offset / (w / excess) - 1) <= 2 * far + 20 * u);
  BOOST_TEST(std::abs(roots[1].value() * m / c - 1) <= 2 * far + 20 * u);
  BOOST_TEST(roots[2].reference == far_pole);
  BOOST_TEST(roots[2].offset < 0);
}

}  // namespace

// A branch so weak that its root lies within rounding of its pole hides no other root.
BOOST_AUTO_TEST_CASE(roots_within_rounding_of_a_pole) {
  for (const double w : {1e-10, 1.4078153398345911e-28, 1e-60, 1e-250})
    check_weak_pole(50.473653028396782, 673076.59886240039, 649.38163157775114, w,
                    70996.968024899121, 1e-9);
}

// (0, p): a double root of m x - c - w/(p - x) splits into two as w falls below (m p - c)^2/(4 m).
BOOST_AUTO_TEST_CASE(two_roots_below_the_first_pole_or_none) {
  for (const double share : {1e-200, 1e-20, 0.5, 0.999}) {
    const double m = 2, p = 3, c = 1, most = (m * p - c) * (m * p - c) / (4 * m);
    const auto roots = positive_roots({m, c, {p}, {share * most}});
    BOOST_TEST_REQUIRE(roots.size() == 2U);
    // d = p - x: m d^2 - (m p - c) d + w = 0.
    const double wide = (m * p - c) / (2 * m) * (1 + std::sqrt(1 - share));
    const double narrow = share * most / m / wide;
    // At a share of 0.999 the square root is 0.03 and carries its error 30 times.
    BOOST_TEST(std::abs((p - roots[0].value()) / wide - 1) <= 200 * u);
    BOOST_TEST(std::abs(-roots[1].minus(p) / narrow - 1) <= 200 * u);
  }
  BOOST_TEST(positive_roots({2, 1, {3}, {1.001 * 25 / 8}}).empty());
}

// (x - r_1)(x - r_2)(x - r_3)/((x - 1)(x - 2)) with three roots between its poles, close to each
// other: slope 1, constant r_1 + r_2 + r_3 - 3, and the residues as weights, all of them exact. A
// rounding of f, whose terms sum to less than 4, counts by the slope there.
BOOST_AUTO_TEST_CASE(three_roots_between_two_poles) {
  for (const double apart : {0.125, 0.0625}) {
    const double weight = 0.5 * (0.5 - apart) * (0.5 + apart);
    const auto roots = positive_roots({1, 1.5, {1, 2}, {weight, weight}});
    BOOST_TEST_REQUIRE(roots.size() == 3U);
    for (int i = 0; i < 3; ++i)
      BOOST_TEST(std::abs(roots[static_cast<std::size_t>(i)].value() - (1.5 + (i - 1) * apart)) <=
                 10 * 4 * u / (4 * apart * apart));
  }
}

// (x - r)((x - q)^2 + s^2)/((x - 1)(x - 2)) rises about q, but has only the root r there, at its
// right or left: slope 1, constant r + 2 q - 3, and the residues as weights, all of them exact.
BOOST_AUTO_TEST_CASE(one_root_where_f_rises_between_two_poles) {
  for (const auto& [r, q] : {std::pair(1.875, 1.375), std::pair(1.125, 1.625)}) {
    const auto numerator = [r, q](double x) { return (x - r) * ((x - q) * (x - q) + 0x1p-6); };
    const auto roots = positive_roots({1, r + 2 * q - 3, {1, 2}, {-numerator(1), numerator(2)}});
    BOOST_TEST_REQUIRE(roots.size() == 1U);
    BOOST_TEST(std::abs(roots[0].value() - r) <= 40 * u);
  }
}

BOOST_AUTO_TEST_SUITE_END()
