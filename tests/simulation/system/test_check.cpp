// A system made by hand, with a member that system.hpp allows no system to have: wrong input, with
// the member's name, whatever is asked of it.
#include "simulation/system/check.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "simulation/methods/methods.hpp"
#include "simulation/steady/energy.hpp"
#include "simulation/steady/exact.hpp"
#include "simulation/steady/normal_force.hpp"
#include "simulation/steady/onset.hpp"
#include "support/refusal.hpp"

BOOST_AUTO_TEST_SUITE(test_check)

using namespace vcrit;
using namespace vcrit::simulation;

namespace {

System good() {
  System system;
  system.contact = {3, 0, {{1, 0.5}}};
  system.drive = Relaxation{2, 0.1, {}};
  system.mass = 1;
  system.omega = 2;
  system.friction = 0.3;
  system.mean_normal_force = 4;
  system.normal_force_amplitude = {1, 1};
  return system;
}

System opening() {
  System system = good();
  system.opening = NormalMotion{{3, 0.1, {}}, 0.1, 0.2};
  return system;
}

template <class Change>
void check_refused(System system, const std::string& words, const Change& change) {
  BOOST_TEST(std::isfinite(steady_state(system, 0.01).friction_ratio));
  change(system);
  BOOST_TEST_CONTEXT(words) {
    BOOST_TEST(test::refused([&] { steady_state(system, 0.01); }, words));
    BOOST_TEST(test::refused([&] { sliding_threshold(system); }, words));
    BOOST_TEST(test::refused([&] { stick_onset(system); }, words));
    BOOST_TEST(test::refused([&] { energy_balance(system, 0.01); }, words));
    BOOST_TEST(test::refused([&] { mean_normal_force(system); }, words));
    for (const Method method : all_methods())
      BOOST_TEST(test::refused([&] { steady_state(method, system, 0.01, {}); }, words));
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(numbers_of_a_closed_contact) {
  check_refused(good(), "normal_force_amplitude: found 8 N about a mean of 4 N",
                [](System& s) { s.normal_force_amplitude = 8; });
  check_refused(good(), "normal_force_amplitude: found not a number",
                [](System& s) { s.normal_force_amplitude = NAN; });
  check_refused(good(), "mean_normal_force: found 0", [](System& s) { s.mean_normal_force = 0; });
  check_refused(good(), "omega: found -2", [](System& s) { s.omega = -2; });
  check_refused(good(), "friction: found 0", [](System& s) { s.friction = 0; });
  check_refused(good(), "friction: found inf", [](System& s) { s.friction = HUGE_VAL; });
  check_refused(good(), "mass: found -1", [](System& s) { s.mass = -1; });
}

BOOST_AUTO_TEST_CASE(networks_of_a_system) {
  check_refused(good(), "contact: found a network of nothing", [](System& s) { s.contact = {}; });
  check_refused(good(), "contact.equilibrium: found -1",
                [](System& s) { s.contact.equilibrium = -1; });
  check_refused(good(), "contact.branches: time: found 0",
                [](System& s) { s.contact.branches[0].time = 0; });
  check_refused(good(), "contact.branches: time: found 0.25", [](System& s) {
    s.contact.branches.push_back({1, 0.25});
  });
  check_refused(good(), "contact.branches: stiffness: found -1",
                [](System& s) { s.contact.branches[0].stiffness = -1; });
  check_refused(good(), "drive.damper: found nan", [](System& s) { s.drive->damper = NAN; });
}

BOOST_AUTO_TEST_CASE(a_contact_that_opens) {
  check_refused(opening(), "opening.amplitude: found 0",
                [](System& s) { s.opening->amplitude = 0; });
  check_refused(opening(), "opening.mean: found nan", [](System& s) { s.opening->mean = NAN; });
  check_refused(opening(), "opening.network.equilibrium: found 0",
                [](System& s) { s.opening->network.equilibrium = 0; });
}

BOOST_AUTO_TEST_SUITE_END()
