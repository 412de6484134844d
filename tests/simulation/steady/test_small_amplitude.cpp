// Oscillations that are small beside the indentation: motion, v* and what friction lacks scale with
// them, so that nothing may be lost however small they are.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "scene/scene.hpp"
#include "simulation/random_systems.hpp"
#include "simulation/steady/exact.hpp"
#include "simulation/steady/onset.hpp"

BOOST_AUTO_TEST_SUITE(test_small_amplitude)

namespace {

using namespace vcrit;
using namespace vcrit::simulation;

System system_named(const std::string& name) {
  return system_of(read_scene(VCRIT_TEST_DATA "/small_amplitude/" + name + ".toml"));
}

// By a program of 50 digits that checks the law of friction on its closed cycles.
struct Known {
  std::string name;
  double velocity, lack;  ///< m/s; 1 - mu/mu0
};
const std::vector<Known> known{
    {"undamped-1001", 6.9145421872694015e-09, 2.6244028442798e-7},
    {"critical-1008", 3.014946362082889e-10, 9.690981143804e-8},
    {"graph-1000", 3.0248154576235684e-08, 1.601e-13},
    {"body-1006", 2.9063023125126347e-15, 6.95805623512e-9},
};

BOOST_AUTO_TEST_CASE(friction_of_bodies) {
  for (const auto& [name, velocity, lack] : known)
    for (const Start start : {Start::sliding, Start::rest}) {
      const SteadyState state = steady_state(system_named(name), velocity, start);
      const double error = state.friction_ratio_error;
      BOOST_TEST(std::abs(1 - state.friction_ratio - lack) <= error, name);
      // The rounding of a number next to 1, and some for the motion.
      BOOST_TEST(error <= 4e-16 + 1e-9 * lack, name << ": " << error);
    }
}

BOOST_AUTO_TEST_CASE(last_stick) {
  for (const char* name : {"graph-1033", "prony-1025", "light-1006"}) {
    const System system = system_named(name);
    const double stick = stick_onset(system).contact_velocity;
    BOOST_TEST(std::abs(stick / sliding_threshold(system).contact_velocity - 1) <= 1e-12, name);
  }
}

// At 1e-13 of the amplitude all is 1e-13 of what it was, as far as a number next to 1 can tell.
BOOST_AUTO_TEST_CASE(lack_of_friction_scales) {
  int bodies = 0;
  for (unsigned i = 0; i < 200; ++i) {
    reference::RandomSystems random(8800 + i, 6);
    System system = random.system();
    system.normal_force_amplitude *=
        0.5 * system.mean_normal_force / std::abs(system.normal_force_amplitude);
    const Onset onset = sliding_threshold(system);
    // Creep of the path does not scale; the motion does, by the contact's velocity.
    const double creep = onset.drive_velocity - onset.contact_velocity;
    const double velocity = 0.4 * onset.contact_velocity;
    const SteadyState large = steady_state(system, creep + velocity);
    // Back slip needs forces that small oscillations do not reach.
    if (large.regime != Regime::stick_slip) continue;
    for (const double share : {1e-3, 1e-8}) {
      if (creep > 1e6 * share * velocity) continue;  // beyond the model's reach
      System small = system;
      small.normal_force_amplitude *= share;
      const SteadyState state = steady_state(small, creep + share * velocity);
      const double lack = share * (1 - large.friction_ratio);
      // The creep is known to a rounding error of the speeds that it is a difference of.
      const double lost = 4e-16 * onset.drive_velocity / velocity;
      BOOST_TEST(std::abs(1 - state.friction_ratio - lack) <=
                     state.friction_ratio_error + share * large.friction_ratio_error + lost,
                 "system " << i << ", " << share);
      bodies += system.mass ? 1 : 0;
    }
  }
  BOOST_TEST(bodies >= 50);
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()
