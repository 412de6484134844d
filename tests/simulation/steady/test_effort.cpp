// The bound on work: counted, so that it strikes at the same place everywhere.
#include "simulation/system/effort.hpp"

#include <boost/test/unit_test.hpp>

#include "simulation/reference_systems.hpp"
#include "simulation/steady/exact.hpp"
#include "simulation/steady/onset.hpp"

BOOST_AUTO_TEST_SUITE(test_effort)

namespace {

using namespace vcrit;
using namespace vcrit::simulation;

BOOST_AUTO_TEST_CASE(one_effort_is_spent_by_all) {
  Effort whole(10), first(8, &whole), second(8, &whole);
  BOOST_CHECK_NO_THROW(first.spend(6));
  BOOST_CHECK_THROW(first.spend(3), ModelError);
  BOOST_CHECK_NO_THROW(second.spend(4));
  BOOST_CHECK_THROW(second.spend(1), ModelError);
  second.renew(8);
  BOOST_CHECK_THROW(second.spend(1), ModelError);
}

// A light body on 20 branches rings a hundred thousand times in a period.
BOOST_AUTO_TEST_CASE(a_body_that_rings_ends) {
  System system = system_of(read_scene(VCRIT_TEST_DATA "/ringing/light-1010.toml"));
  Effort tenth(effort_of_state / 10);
  system.effort = &tenth;
  BOOST_CHECK_THROW(steady_state(system, 2.035514276526095e-08), ModelError);
}

// Each search for a change of motion that is given up takes a million steps, of more than a dozen
// modes each, and there are several. Not counted, they would end with a word on oscillations.
BOOST_AUTO_TEST_CASE(searches_that_are_given_up_count) {
  System system = system_of(read_scene(VCRIT_TEST_DATA "/ringing/harmonic-1095.toml"));
  Effort two_searches(30'000'000);
  system.effort = &two_searches;
  BOOST_CHECK_EXCEPTION(steady_state(system, 5.69e-08), ModelError, [](const ModelError& error) {
    return std::string(error.what()).find("work for all steady states") != std::string::npos;
  });
}

BOOST_AUTO_TEST_CASE(searches_share_the_effort_of_their_system) {
  System system = reference::reference_rows().front().system;
  Effort little(100);
  system.effort = &little;
  BOOST_CHECK_THROW(steady_state(system, 0.1 * sliding_threshold(system).drive_velocity),
                    ModelError);
  system.effort = nullptr;
  BOOST_CHECK_NO_THROW(steady_state(system, 0.1 * sliding_threshold(system).drive_velocity));
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()
