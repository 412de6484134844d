// v* by simulation: where steady sliding ceases to exist, and where the last stick vanishes.
#include "simulation/steady/onset.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "base/errors.hpp"
#include "simulation/random_systems.hpp"
#include "simulation/reference_systems.hpp"
#include "simulation/steady/exact.hpp"

BOOST_AUTO_TEST_SUITE(test_onset)

namespace {

using namespace vcrit;
using namespace vcrit::simulation;

constexpr double u = std::numeric_limits<double>::epsilon() / 2;

BOOST_AUTO_TEST_CASE(last_stick_vanishes_at_the_reference) {
  for (const reference::Row& row : reference::reference_rows()) {
    const Onset onset = stick_onset(row.system);
    // Bisection leaves 2^-50, far below v* eps with sqrt(18 eps) = 1e-6, the shortest stick that
    // rounding of the contact velocity (some 10 u of v*) leaves.
    BOOST_TEST(std::abs(onset.contact_velocity / row.threshold - 1) <= 1e-13, row.name);
  }
}

// Two answers without a common argument: one from the linear response of pure sliding, one from
// marching through stick and slip after a start at rest.
BOOST_AUTO_TEST_CASE(both_witnesses_agree_on_random_systems) {
  constexpr unsigned seed = 1907;
  BOOST_TEST_MESSAGE("seed " << seed);
  for (unsigned i = 0; i < 150; ++i) {
    reference::RandomSystems systems(seed + i, i % 2 == 0 ? 1 : 6);
    const System system = systems.system();
    const Onset sliding = sliding_threshold(system), stick = stick_onset(system);
    // Relative to the drive's speed, which is what both are found at: a creeping path adds to it.
    const double difference = std::abs(stick.drive_velocity - sliding.drive_velocity);
    BOOST_TEST(difference <= 1e-12 * sliding.drive_velocity, "system " << i);
    BOOST_TEST(std::abs(stick.contact_velocity - sliding.contact_velocity) <=
               1e-12 * sliding.drive_velocity);
  }
}

// A body that forgets its start over m/c periods; of what is left of it in 1e13 of them a period
// takes less than some roundings of the contact's velocity.
System settling(double damper, double slowness) {
  System system;
  system.contact = {1, 0, {}};
  system.drive = Relaxation{0, damper, {}};
  system.mass = damper * slowness;
  system.omega = system.friction = system.mean_normal_force = 1;
  system.normal_force_amplitude = 0.5;
  return system;
}

BOOST_AUTO_TEST_CASE(a_body_that_settles_slowly_loses_its_last_stick_there_too) {
  for (const double damper : {1e3, 1e6})
    for (const double slowness : {1e6, 1e9, 1e11, 1e13}) {
      const System system = settling(damper, slowness);
      const Onset sliding = sliding_threshold(system), stick = stick_onset(system);
      BOOST_TEST(std::abs(stick.drive_velocity / sliding.drive_velocity - 1) <= 1e-12,
                 damper << ", " << slowness);
    }
}

// Where nothing tells at what speed the body settles, none is made up, nor a friction ratio there.
BOOST_AUTO_TEST_CASE(a_body_that_never_settles_is_refused) {
  for (const double slowness : {1e16, 1e18, 1e100}) {
    System system = settling(1e3, slowness);
    BOOST_CHECK_THROW(stick_onset(system), ModelError);
    const double velocity = 0.9 * sliding_threshold(system).drive_velocity;
    BOOST_CHECK_THROW(steady_state(system, velocity), ModelError);
    system.contact = {1, 0.1, {}};
    system.opening = {{1, 0, {}}, 0.5, 1};
    BOOST_CHECK_THROW(sliding_threshold(system), ModelError);
  }
}

BOOST_AUTO_TEST_CASE(no_speed_is_high_enough_at_an_undamped_resonance) {
  System system;
  system.contact = {2, 0, {}};
  system.drive = Relaxation{1, 0, {}};
  system.mass = 1;
  system.omega = 1;
  system.friction = 0.5;
  system.mean_normal_force = 1;
  system.normal_force_amplitude = 0.5;
  BOOST_CHECK_THROW(stick_onset(system), ModelError);
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()
