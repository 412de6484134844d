// v* by simulation: where steady sliding ceases to exist, and where the last stick vanishes.
#include "simulation/steady/onset.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "base/errors.hpp"
#include "simulation/random_systems.hpp"
#include "simulation/reference_systems.hpp"
#include "simulation/steady/exact.hpp"
#include "support/refusal.hpp"

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

// A body that keeps its swing nearly by itself: cycles that close within 1000 roundings stick up to
// 33 and 0.3 millionths above the true speeds, which are Eq. 24 of these doubles with 40 digits.
BOOST_AUTO_TEST_CASE(near_resonance_only_closed_cycles_tell_where_the_last_stick_ends) {
  struct Row {
    System system;
    double velocity;
    double condition;  // of Eq. 24: (3 + sqrt(2)) |K_d|/|K_d - m omega^2|
  };
  System light, stiff;
  light.contact = {0.5561592879179026, 0, {}};
  light.drive = Relaxation{0.0857353573306591, 0, {{3.859804017177936e-09, 0.16349222698889465}}};
  light.mass = 7.117073437714877;
  light.omega = 0.10975626289912684;
  light.normal_force_amplitude = 4.520934499334433e-05 * 0.5561592879179026;
  light.mean_normal_force = 1e-3 * 0.5561592879179026;
  stiff.contact = {13651287.452257985, 103458.8291101095, {}};
  stiff.drive = Relaxation{27091893.315565296 / 2, 0.009887899661104507, {}};
  stiff.mass = 3.76490906648504;
  stiff.omega = 1896.8304009355527;
  stiff.normal_force_amplitude = 8.650263163308438e-06 * 13651287.452257985;
  stiff.mean_normal_force = 1e-3 * 13651287.452257985;
  light.friction = stiff.friction = 0.3;
  for (const auto& [system, velocity, condition] :
       {Row{light, 39.037449681508027772, 1.785e7}, Row{stiff, 972.04163366845805881, 8.65e5}}) {
    const Onset last = stick_onset(system);
    BOOST_TEST(std::abs(last.contact_velocity - velocity) <=
               32 * u * condition * velocity + last.uncertainty);
    BOOST_TEST(last.uncertainty <= 1e-10 * velocity);
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

// On a drive with a slow branch every velocity of so heavy a body closes a cycle: 1.55 v* was
// found.
BOOST_AUTO_TEST_CASE(the_last_stick_of_a_body_that_never_settles_is_not_made_up) {
  for (const double mass : {1e18, 1e21, 1e24}) {
    System system;
    system.contact = {0.8, 0, {{0.3, 0.9}}};
    system.drive = Relaxation{0, 0, {{0.2, 6}}};
    system.mass = mass;
    system.omega = system.mean_normal_force = 1;
    system.friction = 0.3;
    system.normal_force_amplitude = 0.5;
    BOOST_TEST(test::refused<ModelError>([&] { stick_onset(system); }, "the body is so heavy"));
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
