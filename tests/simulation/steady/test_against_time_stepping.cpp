// Whole steady states against implicit time stepping. Its error is of first order, so that with a
// step h and half of it, r(h) - r(h/2) is the error of r(h/2) to leading order; twice that is
// allowed.
#include <boost/test/unit_test.hpp>

#include "simulation/steady/exact.hpp"
#include "simulation/steady/onset.hpp"
#include "time_stepping.hpp"

BOOST_AUTO_TEST_SUITE(test_against_time_stepping)

namespace {

using namespace vcrit;
using namespace vcrit::simulation;

System base() {
  System s;
  s.omega = 1;
  s.friction = 0.5;
  s.mean_normal_force = 1;
  s.normal_force_amplitude = 0.8;
  return s;
}

void compare(const System& system, double share, int steps = 4000) {
  const Onset threshold = sliding_threshold(system);
  const double velocity = threshold.drive_velocity * share;
  const double coarse = reference::stepped_friction_ratio(system, velocity, 120, steps);
  const double fine = reference::stepped_friction_ratio(system, velocity, 120, 2 * steps);
  const SteadyState exact = steady_state(system, velocity);
  BOOST_TEST(std::abs(coarse - fine) < 1e-3);
  BOOST_TEST(std::abs(coarse - fine) > 1e-9);
  BOOST_TEST(std::abs(exact.friction_ratio - fine) <= 2 * std::abs(coarse - fine));
}

}  // namespace

BOOST_AUTO_TEST_CASE(kelvin_contact) {
  System s = base();
  s.contact = {1, 1, {}};
  for (const double share : {0.05, 0.3, 0.8}) compare(s, share);
}

BOOST_AUTO_TEST_CASE(fluid_contact_that_creeps) {
  System s = base();
  s.contact = {0, 0, {{2, 3}}};
  for (const double share : {0.3, 0.6, 0.9}) compare(s, share);
}

BOOST_AUTO_TEST_CASE(massless_body_between_contact_and_drive) {
  System s = base();
  s.contact = {1, 0, {{0.5, 0.3}, {2, 5}}};
  s.drive = Relaxation{0.7, 0.2, {}};
  for (const double share : {0.05, 0.5}) compare(s, share);
}

// Stuck, the body hangs on k = 2 and c = 2 sqrt(2 x 0.5) = 2: critically damped.
BOOST_AUTO_TEST_CASE(critically_damped_when_stuck) {
  System s = base();
  s.contact = {1.5, 1.5, {}};
  s.drive = Relaxation{0.5, 0.5, {}};
  s.mass = 0.5;
  for (const double share : {0.1, 0.6}) compare(s, share);
}

// Slipping, on k_d = 1 and c_d = 2 sqrt(1 x 1) = 2; and far beyond.
BOOST_AUTO_TEST_CASE(critically_and_over_damped_when_slipping) {
  for (const double damper : {2.0, 20.0}) {
    System s = base();
    s.contact = {1.5, 0, {{1, 0.4}}};
    s.drive = Relaxation{1, damper, {}};
    s.mass = 1;
    for (const double share : {0.1, 0.6}) compare(s, share);
  }
}

BOOST_AUTO_TEST_CASE(body_under_a_drive_with_branches) {
  System s = base();
  s.contact = {1, 0, {{0.5, 0.2}, {1, 2}}};
  s.drive = Relaxation{0.5, 0.1, {{0.3, 1}, {1, 4}}};
  s.mass = 0.8;
  for (const double share : {0.05, 0.4}) compare(s, share);
}

BOOST_AUTO_TEST_CASE(drive_that_creeps) {
  System s = base();
  s.contact = {1, 0, {{0.5, 0.2}}};
  s.drive = Relaxation{0, 0.6, {{1, 2}}};
  s.mass = 0.8;
  compare(s, 0.7);
}

// Stuck, the body swings on k + k_d = 2 at 4.5 omega and throws the contact backwards.
BOOST_AUTO_TEST_CASE(backward_slip) {
  System s = base();
  s.contact = {1, 0, {}};
  s.drive = Relaxation{1, 0.05, {}};
  s.mass = 0.1;
  s.normal_force_amplitude = 0.97;
  for (const double share : {0.25, 0.3}) {
    const double velocity = share * sliding_threshold(s).drive_velocity;
    BOOST_TEST((steady_state(s, velocity).regime == Regime::stick_slip_backslip));
    compare(s, share, 16000);
  }
}

BOOST_AUTO_TEST_SUITE_END()
