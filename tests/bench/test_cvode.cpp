// The exact simulator and SUNDIALS CVODE, which share nothing but the system, find the same
// friction; and CVODE finds the 50-digit references.
//
// CVODE keeps its estimate of each step's error below rtol in units of the friction bound. A period
// takes up to 10^3 steps at rtol = 1e-11, and what errs in one is remembered for at most some ten
// periods of the systems here where Newton's method closes the cycle: 10^4 rtol is allowed.
#include <boost/test/unit_test.hpp>

#include "simulation/random_systems.hpp"
#include "simulation/reference_systems.hpp"
#include "simulation/steady/exact.hpp"
#include "simulation/steady/onset.hpp"
#include "simulators/cvode.hpp"

BOOST_AUTO_TEST_SUITE(test_cvode)

namespace {

using namespace vcrit;
using simulators::cvode_steady_state;
using simulators::CvodeOptions;
using simulators::Multistep;

constexpr double rtol = 1e-11;
constexpr double allowed = 1e4 * rtol;

CvodeOptions options(Multistep formula, bool newton) { return {formula, rtol, newton}; }

}  // namespace

BOOST_AUTO_TEST_CASE(finds_the_references) {
  for (const reference::Row& row : reference::reference_rows()) {
    BOOST_TEST_CONTEXT(row.name) {
      const auto found =
          cvode_steady_state(row.system, row.velocity, options(Multistep::bdf, true));
      BOOST_TEST(std::abs(found.friction_ratio - row.friction_ratio) < allowed);
      BOOST_TEST(static_cast<std::size_t>(found.events) == row.events);
    }
  }
}

// Marching and Adams' formulas take another way to the same cycle; slow and stiff rows are not for
// them.
BOOST_AUTO_TEST_CASE(finds_them_by_marching_and_by_adams) {
  for (const reference::Row& row : reference::reference_rows()) {
    if (row.name[1] == '3' || row.name.starts_with("P1, delta 100,")) continue;
    BOOST_TEST_CONTEXT(row.name) {
      for (const Multistep formula : {Multistep::bdf, Multistep::adams}) {
        const auto found = cvode_steady_state(row.system, row.velocity, options(formula, false));
        BOOST_TEST(std::abs(found.friction_ratio - row.friction_ratio) < allowed);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(agrees_with_the_exact_simulator_on_random_systems) {
  reference::RandomSystems random(20, 1.5);
  for (int i = 0; i < 20; ++i) {
    const simulation::System system = random.system();
    const double velocity =
        random.uniform(0.1, 0.97) * simulation::sliding_threshold(system).drive_velocity;
    BOOST_TEST_CONTEXT("system " << i) {
      const auto found = cvode_steady_state(system, velocity, options(Multistep::bdf, true));
      const auto exact = simulation::steady_state(system, velocity);
      BOOST_TEST(std::abs(found.friction_ratio - exact.friction_ratio) < allowed);
    }
  }
}

BOOST_AUTO_TEST_CASE(says_that_it_has_not_finished) {
  const reference::Row row = reference::reference_rows().front();
  BOOST_CHECK_THROW(cvode_steady_state(row.system, row.velocity, {Multistep::bdf, rtol, false, 5}),
                    simulators::NotFinished);
}

BOOST_AUTO_TEST_SUITE_END()
