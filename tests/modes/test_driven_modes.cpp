// Linear motion pushed by decaying forces, near to resonance and far from it, against a matrix
// exponential in long double.
#include "modes/driven_modes.hpp"

#include <Eigen/Core>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

#include "base/errors.hpp"
#include "modes/body_modes.hpp"
#include "support/exponential.hpp"

BOOST_AUTO_TEST_SUITE(test_driven_modes)

namespace {

using namespace vcrit;
using namespace vcrit::simulation;
using Real = test::WideMatrix;

constexpr double u = 1.1e-16;

// y' = A y + direction p' with the modes' own A, beside decays.
struct Case {
  Real matrix;
  Modes own;
  Vector direction, rates;
};

Real whole(const Case& c) {
  const Eigen::Index n = c.matrix.rows(), m = static_cast<Eigen::Index>(c.rates.size());
  Real result = Real::Zero(n + m, n + m);
  result.topLeftCorner(n, n) = c.matrix;
  for (Eigen::Index i = 0; i < m; ++i) {
    const long double rate = c.rates[static_cast<Index>(i)];
    result(n + i, n + i) = -rate;
    for (Eigen::Index j = 0; j < n; ++j)
      result(j, n + i) = -rate * c.direction[static_cast<Index>(j)];
  }
  return result;
}

void check(const Case& c, double roundings) {
  const Modes modes = driven(c.own, c.direction, c.rates);
  const Index n = modes.to_modes.columns();
  BOOST_REQUIRE(modes.to_modes.rows() == modes.spectrum.size());
  for (Index start = 0; start < n; ++start)
    for (const double t : {0.0, 0.1, 1.0, 7.0}) {
      const Real exact = test::exponential(whole(c) * static_cast<long double>(t));
      Vector after(n);
      ModalFactors(modes.spectrum, t)
          .apply(modes.to_modes.column(start), [&](Index mode, const Integrals<double>& passed) {
            add(modes.from_modes.column(mode), passed[0], after);
          });
      for (Index j = 0; j < n; ++j)
        BOOST_TEST(std::abs(after[j] - static_cast<double>(exact(
                                           static_cast<Eigen::Index>(j),
                                           static_cast<Eigen::Index>(start)))) <= roundings * u);
    }
}

Case creeping(const Vector& own, const Vector& direction, const Vector& rates) {
  Real matrix =
      Real::Zero(static_cast<Eigen::Index>(own.size()), static_cast<Eigen::Index>(own.size()));
  for (Index i = 0; i < own.size(); ++i)
    matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i)) =
        -static_cast<long double>(own[i]);
  return {matrix, uncoupled(own), direction, rates};
}

// m a' = -c a - h, h' = k a - rate h.
Case swinging(double mass, double damper, double rate, double stiffness, const Vector& rates) {
  Real matrix(2, 2);
  matrix << -damper / mass, -1 / mass, stiffness, -rate;
  return {matrix, body_modes(mass, {damper, {rate}, {stiffness}}), {-1 / mass, 0}, rates};
}

}  // namespace

// Coefficients of separate modes are at most some ten times what they add up to (close_share), and
// a dozen terms of a few roundings each are summed.
BOOST_AUTO_TEST_CASE(creep_near_and_far_from_resonance) {
  for (const double distance : {0.0, 1e-15, 1e-9, 1e-4, 0.05, 0.19, 0.21, 0.5})
    for (const double side : {-1.0, 1.0})
      check(creeping({0.3, 2}, {1, 0.7}, {0.3 * (1 + side * distance), 1, 40}), 500);
}

BOOST_AUTO_TEST_CASE(one_rate_between_two) {
  check(creeping({1}, {1}, {0.95, 1, 1.07}), 500);
  check(creeping({0.93, 1.04}, {1, -0.4}, {1}), 500);
  check(creeping({1, 1.5}, {0, 1}, {1}), 500);
}

BOOST_AUTO_TEST_CASE(bodies) {
  check(swinging(1, 0.2, 0, 1, {0.3, 2}), 500);  // swings
  check(swinging(1, 0.2, 0.5, 1, {0.3, 0.55, 2}), 500);
  check(swinging(0.1, 3, 0, 1, {0.33, 30}), 2000);  // overdamped, modes near 0.338 and 29.7
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0.1, 3);
  for (int i = 0; i < 200; ++i)
    check(swinging(uniform(random), uniform(random), uniform(random), uniform(random),
                   {uniform(random), 4 + uniform(random)}),
          20'000);
}

BOOST_AUTO_TEST_CASE(three_at_one_place_are_refused) {
  const Case critical = swinging(1, 2, 0, 1, {1});
  BOOST_CHECK_THROW(driven(critical.own, critical.direction, critical.rates), ModelError);
}

BOOST_AUTO_TEST_SUITE_END()
