// Systems that a search over a hundred thousand random ones has found hard: both starts lead to the
// same friction within what both say of themselves, between the static bound and 1.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>

#include "base/errors.hpp"
#include "scene/scene.hpp"
#include "simulation/steady/exact.hpp"
#include "simulation/steady/onset.hpp"
#include "support/refusal.hpp"

BOOST_AUTO_TEST_SUITE(test_hard_systems)

using namespace vcrit;
using namespace vcrit::simulation;

namespace {

constexpr double u = 1.1e-16;

struct Scene {
  Relaxation contact, drive;
  double mass, amplitude, phase, share;  ///< share of the threshold
};

void check(const std::string& name, const Scene& scene, double error) {
  System system;
  system.contact = scene.contact;
  system.drive = scene.drive;
  system.mass = scene.mass;
  system.omega = 1;
  system.friction = 1;
  system.mean_normal_force = 1;
  system.normal_force_amplitude = std::polar(scene.amplitude, scene.phase);
  const Onset threshold = sliding_threshold(system);
  const double velocity = scene.share * threshold.drive_velocity;
  const SteadyState slid = steady_state(system, velocity, Start::sliding);
  const SteadyState rested = steady_state(system, velocity, Start::rest);
  BOOST_TEST_CONTEXT(name) {
    BOOST_TEST(std::abs(slid.friction_ratio - rested.friction_ratio) <=
               slid.friction_ratio_error + rested.friction_ratio_error);
    BOOST_TEST(slid.friction_ratio_error <= error);
    BOOST_TEST(rested.friction_ratio_error <= error);
    BOOST_TEST(slid.friction_ratio <= 1 + slid.friction_ratio_error);
    BOOST_TEST(slid.friction_ratio >= 1 - scene.amplitude);
    // What creeps at speed C under mu0 <F_n>, and slips as much as it moves less that.
    const double creep = threshold.drive_velocity - threshold.contact_velocity;
    if (creep > 0)
      BOOST_TEST(slid.friction_ratio <= velocity / creep * (1 + 4 * u) + slid.friction_ratio_error);
  }
}

}  // namespace

// A branch of the drive that relaxes over 1e11 periods with a share of 1e-32 of its stiffness.
BOOST_AUTO_TEST_CASE(slow_branches_far_apart) {
  check("slow branches",
        {{3.6517412725483771, 0, {}},
         {0,
          0,
          {{2102.2678543826451, 0.0026749105241598088},
           {2.9473549225195754e-08, 1182.1994095966475},
           {4.2169650474848838e-32, 86596432822.974075}}},
         0.153993,
         0.724,
         0.153993,
         0.99999994039535522},
        1e-14);
}

// A branch of the drive of 1e-28 of its damper: a mode lies within rounding of its pole.
BOOST_AUTO_TEST_CASE(mode_within_rounding_of_a_pole) {
  check("weak branch",
        {{0, 1.5399265260594919e-05, {{0.013335214321633241, 3.6517412725483771}}},
         {0,
          8659.6432336006528,
          {{0.00039924529083610417, 1.4085108530962803e-05},
           {1.8112616903280737e-30, 0.0015399265260558404}}},
         0.649382,
         0.47,
         0.649382,
         0.99999994039535522},
        1e-14);
}

// A drive that creeps 4e6 times faster than the contact swings: the body's velocity relative to the
// drive has no more digits of the contact's than that leaves, and near the threshold the cycle
// depends on them steeply.
BOOST_AUTO_TEST_CASE(fast_creep) {
  check("damper",
        {{0, 0, {{27.384196342643612, 421696.50342858228}}},
         {0, 7.4984551574201141e-06, {}},
         std::pow(10, -1 / 16.0),
         0.03,
         std::pow(10, -1 / 16.0),
         0.99999998509883881},
        1e-10);
}

// One whose search from rest never settles, and one whose search from sliding is led far away: each
// is found from the other start, so that only the answer and its bounds are tried here, not
// agreement.
BOOST_AUTO_TEST_CASE(one_start_serves_for_the_other) {
  check("undamped drive",
        {{0, 0, {{0.056234132519034905, 0.0042127407572765431}}},
         {153.99265260594919, 0, {}},
         1.15478,
         0.153,
         1.15478,
         0.999969482421875},
        1e-14);
  check(
      "soft drive",
      {{74.989420933245583, 0, {{0.032737002637618466, 0.083151947121547248}}},
       {0.042169650342858224,
        0,
        {{0.31342622798917041, 0.065210121202819049}, {0.0028015380276674938, 23.614839194516335}}},
       std::pow(10, 15 / 16.0),
       0.137,
       std::pow(10, 15 / 16.0),
       0.015399265260594919},
      1e-13);
}

BOOST_AUTO_TEST_CASE(creep_beyond_what_numbers_hold_is_told) {
  System system;
  system.contact = {1778.2796838808863, 0, {}};
  system.drive = Relaxation{0, 1e-10, {}};
  system.mass = 0.133352;
  system.omega = 1;
  system.friction = 1;
  system.mean_normal_force = 1;
  system.normal_force_amplitude = 0.334;
  const double velocity = 0.9 * sliding_threshold(system).drive_velocity;
  BOOST_CHECK_EXCEPTION(steady_state(system, velocity), ModelError, [](const ModelError& error) {
    return std::string(error.what()).find("lost in rounding") != std::string::npos;
  });
}

// Searches end in drift, in motion without bound or in ringing, which is not what is wrong.
BOOST_AUTO_TEST_CASE(parts_that_lie_too_far_apart_are_named) {
  const auto words = [](double contact, double drive, double mass) {
    System system;
    system.contact = {contact, 0.1, {}};
    system.drive = Relaxation{drive, 0, {}};
    system.mass = mass;
    system.omega = system.friction = system.mean_normal_force = 1;
    system.normal_force_amplitude = 0.5;
    return test::refusal<ModelError>(
        [&] { steady_state(system, 0.5 * sliding_threshold(system).drive_velocity); });
  };
  BOOST_TEST(test::has(words(1, 0.3, 1e-150), "the body's inertia m omega^2 lies 150 orders of"));
  BOOST_TEST(test::has(words(1, 0.3, 1e155), "the stiffness of the drive lies 156 orders of"));
  BOOST_TEST(test::has(words(1e100, 0.3, 2), "below the stiffness of the contact"));
  // Nearer to each other, it is the search itself.
  BOOST_TEST(test::has(words(1e14, 0.3, 2), "the body rings"));
}

BOOST_AUTO_TEST_SUITE_END()
