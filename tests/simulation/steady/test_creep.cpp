// Paths that creep, K(s) ~ eta s: where nothing slips, and what it takes to slide.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "simulation/steady/exact.hpp"
#include "simulation/steady/onset.hpp"

BOOST_AUTO_TEST_SUITE(test_creep)

namespace {

using namespace vcrit;
using namespace vcrit::simulation;

constexpr double u = 1.1e-16;

// mu0 <F_n> = 1, mu0 min F_n = 0.2.
System creeping(const Relaxation& contact) {
  System s;
  s.contact = contact;
  s.omega = 1;
  s.friction = 0.5;
  s.mean_normal_force = 2;
  s.normal_force_amplitude = {0, 1.6};
  return s;
}

const Relaxation branch{0, 0, {{2, 1.5}}};  // eta = 3

}  // namespace

// Below mu0 min F_n/eta the force eta v0 never reaches the bound: mu_macro/mu0 = eta v0/(mu0
// <F_n>).
BOOST_AUTO_TEST_CASE(sticks_for_ever_below_the_bound) {
  for (const Start start : {Start::sliding, Start::rest})
    for (const double force : {1e-6, 0.1, 0.1999999}) {
      const SteadyState state = steady_state(creeping(branch), force / 3, start, 4);
      BOOST_TEST((state.regime == Regime::stick));
      BOOST_TEST(std::abs(state.friction_ratio - force) <= 10 * u);
      BOOST_TEST(state.events.empty());
      BOOST_TEST(state.periods.value_or(0) == 1);
      for (const CyclePoint& point : state.cycle) {
        BOOST_TEST(point.contact_velocity == 0.0);
        BOOST_TEST(std::abs(point.force - force) <= 10 * u);
      }
    }
}

// However slow: eta v0 was lost beside the bound, with an error of 1e-31 for 0.
BOOST_AUTO_TEST_CASE(sticks_with_all_digits_at_rest) {
  for (int decade = -1; decade >= -300; decade -= 13) {
    const double force = std::pow(10, decade);
    const SteadyState state = steady_state(creeping(branch), force / 3, Start::rest, 1);
    BOOST_TEST(std::abs(state.friction_ratio / force - 1) <= 10 * u, decade);
    BOOST_TEST(std::abs(state.friction_ratio - force) <= state.friction_ratio_error, decade);
    BOOST_TEST(std::abs(state.cycle.front().force / force - 1) <= 10 * u, decade);
  }
}

// Just above it slips once a period, where the bound is lowest: phase pi less that of F_n, pi/2.
BOOST_AUTO_TEST_CASE(slips_where_the_bound_is_lowest) {
  for (const Start start : {Start::sliding, Start::rest}) {
    const SteadyState state = steady_state(creeping(branch), 0.2001 / 3, start);
    BOOST_TEST((state.regime == Regime::stick_slip));
    BOOST_TEST_REQUIRE(state.events.size() == 2U);
    // b - 0.2 = 0.8 (1 - cos) reaches 1e-4 at +-0.0158, where slip begins at the latest.
    for (const Event& event : state.events) BOOST_TEST(std::abs(event.phase - 1.5708) < 0.03);
    BOOST_TEST(state.friction_ratio < 0.2001);
    BOOST_TEST(state.friction_ratio > 0.2);
  }
}

// A spring behind a damper: w = v0 - F'/k - F/eta, so v* = 0.8 |i/k + 1/eta|, and the drive runs
// 1/eta faster.
BOOST_AUTO_TEST_CASE(threshold_of_a_creeping_contact) {
  const Onset threshold = sliding_threshold(creeping(branch));
  const double lowest = 0.8 * std::hypot(0.5, 1.0 / 3);
  BOOST_TEST(std::abs(threshold.contact_velocity / lowest - 1) <= 20 * u);
  BOOST_TEST(std::abs(threshold.drive_velocity / (lowest + 1.0 / 3) - 1) <= 20 * u);
  BOOST_TEST(steady_state(creeping(branch), threshold.drive_velocity * 1.0001).events.empty());
  BOOST_TEST(steady_state(creeping(branch), threshold.drive_velocity * 0.9999).events.size() == 2U);
}

// A damper alone: F = min(eta v0, b) at each moment, as nothing is stored.
BOOST_AUTO_TEST_CASE(a_damper_alone) {
  const double eta = 0.7;
  for (const double force : {0.3, 1.0, 1.7}) {
    const SteadyState state = steady_state(creeping({0, eta, {}}), force / eta);
    // <min(f, 1 + 0.8 cos t)> with the bound below f for |t - pi| < a, cos a = (1 - f)/0.8.
    const double a = std::acos((1 - force) / 0.8), pi = std::acos(-1.0);
    const double mean = (force * (pi - a) + a - 0.8 * std::sin(a)) / pi;
    BOOST_TEST(std::abs(state.friction_ratio - mean) <= 30 * u);
  }
}

// Contact and drive creep one behind the other: their fluidities add, with a body or without.
BOOST_AUTO_TEST_CASE(creep_adds_along_the_path) {
  System s = creeping(branch);
  s.drive = Relaxation{0, 5, {}};
  for (const bool moving : {false, true}) {
    if (moving) s.mass = 0.3;
    const Onset threshold = sliding_threshold(s);
    const double creep = threshold.drive_velocity - threshold.contact_velocity;
    BOOST_TEST(std::abs(creep - (1.0 / 3 + 1.0 / 5)) <= 20 * u);
    const SteadyState stuck = steady_state(s, 0.1 * (1.0 / 3 + 1.0 / 5), Start::rest);
    BOOST_TEST((stuck.regime == Regime::stick));
    BOOST_TEST(std::abs(stuck.friction_ratio - 0.1) <= 20 * u);
  }
}

BOOST_AUTO_TEST_SUITE_END()
