// Steady states where the caller has changed how the processor rounds, or has it flush subnormal
// numbers to zero.
#include <boost/test/unit_test.hpp>

#include <cmath>

#include "simulation/reference_systems.hpp"
#include "simulation/steady/exact.hpp"
#include "support/arithmetic_state.hpp"

BOOST_AUTO_TEST_SUITE(test_steady_rounding_modes)

namespace {

using namespace vcrit;
using namespace vcrit::simulation;

SteadyState steady_state_in(const test::ArithmeticState& arithmetic, const reference::Row& row,
                            Start start) {
  const test::WithArithmetic here(arithmetic);
  SteadyState state = steady_state(row.system, row.velocity, start);
  BOOST_TEST(here.is_kept());
  return state;
}

}  // namespace

BOOST_AUTO_TEST_CASE(reference_values_in_every_state) {
  double worst = 0;
  for (const reference::Row& row : reference::reference_rows())
    for (const test::ArithmeticState& arithmetic : test::all_arithmetic_states())
      for (const Start start : {Start::sliding, Start::rest})
        BOOST_TEST_CONTEXT(row.name << ", " << test::to_text(arithmetic)) {
          const SteadyState state = steady_state_in(arithmetic, row, start);
          const double error = std::abs(state.friction_ratio - row.friction_ratio);
          BOOST_TEST(error <= state.friction_ratio_error + 0x1p-52);
          BOOST_TEST(state.events.size() == row.events);
          worst = std::max(worst, error);
        }
  BOOST_TEST_MESSAGE("largest error " << worst);
}

BOOST_AUTO_TEST_SUITE_END()
