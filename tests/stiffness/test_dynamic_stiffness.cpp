// K(i omega) in doubles against nodal analysis at 250 digits.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <complex>

#include "stiffness/dynamic_stiffness.hpp"
#include "support/nodal.hpp"
#include "support/random_scene.hpp"

BOOST_AUTO_TEST_SUITE(test_dynamic_stiffness)

using namespace vcrit;

namespace {

double worst_error(unsigned seed, double decades, int elements, int networks) {
  test::RandomScenes random(seed, decades);
  double worst = 0;
  for (int i = 0; i < networks; ++i) {
    Scene scene = random.scene(1);
    scene.elements.clear();
    const Network network = random.network(elements, "x", scene);
    Values values;
    for (const auto& [symbol, value] : scene.elements) values[symbol] = *value;
    const double omega = *scene.angular_frequency.value;
    const auto exact = test::Nodal(values, test::Real(omega)).stiffness(network);
    worst = std::max(worst, test::relative_error(dynamic_stiffness(network, values, omega), exact));
  }
  return worst;
}

}  // namespace

// Each step errs by at most 10 units u = 2^-53 of its own norm and passes errors on by at most
// sqrt(2) (Tellegen: K = sum |T_j|^2 z_j, dK/dz_j = T_j^2), so n elements in n - 1 combinations err
// by at most sqrt(2) (10 (n - 1) + 1) u.
BOOST_AUTO_TEST_CASE(twelve_elements_over_many_decades) {
  const double bound = std::sqrt(2) * 111 * std::ldexp(1, -53);
  BOOST_TEST(worst_error(31, 3, 12, 150) < bound);
  BOOST_TEST(worst_error(32, 10, 12, 150) < bound);
}

BOOST_AUTO_TEST_CASE(squares_beyond_the_range_of_doubles_do_no_harm) {
  const Values values{{{"k1"}, 1e200}, {{"c1"}, 2e200}, {{"k2"}, 1e-200}, {{"c2"}, 1e-199}};
  const Network big = series({spring({"k1"}), damper({"c1"})});
  const Network small = series({spring({"k2"}), damper({"c2"})});
  for (const Network& network : {big, small}) {
    const auto exact = test::Nodal(values, test::Real(0.5)).stiffness(network);
    BOOST_TEST(test::relative_error(dynamic_stiffness(network, values, 0.5), exact) <
               20 * std::ldexp(1, -53));
  }
}

BOOST_AUTO_TEST_CASE(a_maxwell_branch_by_its_time) {
  const Network branch = maxwell({"k", 1}, {"tau", 1});
  for (const double omega : {1e-12, 1e-3, 1.0, 1e3, 1e12}) {
    const Values values{{{"k", 1}, 3.0}, {{"tau", 1}, 0.7}};
    const auto exact = test::Nodal(values, test::Real(omega)).stiffness(branch);
    BOOST_TEST(test::relative_error(dynamic_stiffness(branch, values, omega), exact) <
               10 * std::ldexp(1, -53));
  }
}

BOOST_AUTO_TEST_SUITE_END()
