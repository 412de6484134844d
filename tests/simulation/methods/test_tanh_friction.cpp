// Friction as tanh of the velocity goes to Coulomb's as w_reg -> 0, to first order.
#include "simulation/methods/methods.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "simulation/reference_systems.hpp"

BOOST_AUTO_TEST_SUITE(test_tanh_friction)

namespace {

using namespace vcrit;
using namespace vcrit::simulation;

SteadyState smoothed(const reference::Row& row, double regularisation) {
  MethodOptions options;
  options.regularisation = regularisation;
  options.tolerance = 1e-7;
  return steady_state(Method::tanh, row.system, row.velocity, options);
}

double error(const reference::Row& row, double regularisation) {
  return std::abs(smoothed(row, regularisation).friction_ratio - row.friction_ratio);
}

}  // namespace

// Each tenth of w_reg leaves a tenth of the error, but for second-order terms of relative size
// w_reg times some: between a seventh and a fifteenth for w_reg << 1. The integrator's error, some
// 30 times 1e-7 at most, stays below.
BOOST_AUTO_TEST_CASE(converges_to_coulombs_law) {
  const std::vector<reference::Row> rows = reference::reference_rows();
  for (const std::size_t i : {0U, 3U, 4U, 6U, 7U, 12U, 16U, 25U, 30U})
    BOOST_TEST_CONTEXT(rows[i].name) {
      const double coarse = error(rows[i], 1e-2), fine = error(rows[i], 1e-3);
      BOOST_TEST(fine < coarse / 7);
      BOOST_TEST(fine > coarse / 15);
    }
}

// Creep in stick, at most w_reg for the whole period, and a contact velocity that turns w_reg too
// late: changes of order w_reg, here below 10 w_reg for systems that amplify by some.
BOOST_AUTO_TEST_CASE(reference_values) {
  int covered = 0, rows = 0;
  for (const reference::Row& row : reference::reference_rows()) BOOST_TEST_CONTEXT(row.name) {
      const SteadyState state = smoothed(row, 1e-3);
      const double error = std::abs(state.friction_ratio - row.friction_ratio);
      BOOST_TEST(error < 1e-2);
      covered += error <= state.friction_ratio_error;
      ++rows;
      // Near v* the velocity stays above w_reg: the stick is lost.
      const bool near_critical = row.velocity > 0.9 * row.threshold;
      BOOST_TEST((state.events.size() == row.events || near_critical));
    }
  BOOST_TEST(covered >= 0.9 * rows);
}

BOOST_AUTO_TEST_CASE(slides_above_the_critical_velocity) {
  for (const reference::Row& row : reference::reference_rows()) {
    if (row.velocity < 0.9 * row.threshold) continue;
    reference::Row fast = row;
    fast.velocity = 1.1 * row.threshold;
    const SteadyState state = smoothed(fast, 1e-3);
    // w >= 0.1 v0 = 100 w_reg: 1 - tanh vanishes.
    BOOST_TEST(std::abs(state.friction_ratio - 1) < 1e-9, row.name);
    BOOST_TEST((state.regime == Regime::sliding));
  }
}

BOOST_AUTO_TEST_SUITE_END()
