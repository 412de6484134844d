// The bound on work: counted, so that it strikes at the same place everywhere.
#include "simulation/system/effort.hpp"

#include <atomic>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <thread>
#include <vector>

#include "modes/contact_modes.hpp"
#include "scene/scene.hpp"
#include "simulation/reference_systems.hpp"
#include "simulation/steady/exact.hpp"
#include "simulation/steady/onset.hpp"

BOOST_AUTO_TEST_SUITE(test_effort)

namespace {

using namespace vcrit;
using namespace vcrit::simulation;

BOOST_AUTO_TEST_CASE(one_effort_is_spent_by_all) {
  SharedEffort whole(10);
  Effort first(8, &whole), second(8, &whole);
  BOOST_CHECK_NO_THROW(first.spend(6));
  BOOST_CHECK_THROW(first.spend(3), ModelError);
  BOOST_CHECK_NO_THROW(second.spend(4));
  BOOST_CHECK_THROW(second.spend(1), ModelError);
  second.renew(8);
  BOOST_CHECK_THROW(second.spend(1), ModelError);
}

// One unit more is too much, in whatever order threads take them; what none of them was told in
// time is told in the end.
BOOST_AUTO_TEST_CASE(threads_spend_no_more_than_there_is) {
  constexpr std::size_t each = 300'000, threads = 4;
  for (const std::size_t missing : {0, 1}) {
    SharedEffort whole(threads * each - missing);
    std::atomic<int> refused = 0;
    std::vector<std::thread> all;
    for (std::size_t i = 0; i < threads; ++i)
      all.emplace_back([&] {
        Effort effort(2 * each, &whole);
        try {
          for (std::size_t done = 0; done < each; done += 3) effort.spend(3);
        } catch (const ModelError&) {
          ++refused;
        }
      });
    for (std::thread& thread : all) thread.join();
    BOOST_TEST(refused.load() <= static_cast<int>(missing));
    if (missing == 0)
      BOOST_CHECK_NO_THROW(whole.require_enough());
    else
      BOOST_CHECK_THROW(whole.require_enough(), ModelError);
  }
}

// A light body on 20 branches rings a hundred thousand times in a period.
BOOST_AUTO_TEST_CASE(a_body_that_rings_ends) {
  System system = system_of(read_scene(VCRIT_TEST_DATA "/ringing/light-1010.toml"));
  SharedEffort tenth(effort_of_state / 10);
  system.effort = &tenth;
  BOOST_CHECK_THROW(steady_state(system, 2.035514276526095e-08), ModelError);
}

// Each search for a change of motion that is given up takes a million steps, of more than a dozen
// modes each, and there are several. Not counted, they would end with a word on oscillations. The
// drive is off its harmonic by more than rounding, so that the motion is not known beforehand.
BOOST_AUTO_TEST_CASE(searches_that_are_given_up_count) {
  System system = system_of(read_scene(VCRIT_TEST_DATA "/ringing/harmonic-1095.toml"));
  system.drive->equilibrium *= 1 + 1e-13;
  SharedEffort two_searches(30'000'000);
  system.effort = &two_searches;
  BOOST_CHECK_EXCEPTION(steady_state(system, 5.69e-08), ModelError, [](const ModelError& error) {
    return std::string(error.what()).find("work for all steady states") != std::string::npos;
  });
}

BOOST_AUTO_TEST_CASE(searches_share_the_effort_of_their_system) {
  System system = reference::reference_rows().front().system;
  SharedEffort little(100);
  system.effort = &little;
  BOOST_CHECK_THROW(steady_state(system, 0.1 * sliding_threshold(system).drive_velocity),
                    ModelError);
  system.effort = nullptr;
  BOOST_CHECK_NO_THROW(steady_state(system, 0.1 * sliding_threshold(system).drive_velocity));
}

// Contact branches over six decades of relaxation time.
Relaxation many_branches(std::size_t count) {
  Relaxation result{1, 0, {}};
  for (std::size_t i = 0; i < count; ++i) {
    const double place = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    result.branches.push_back({1 / static_cast<double>(count), std::pow(10, 6 * place - 3)});
  }
  return result;
}

System of_many_branches(std::size_t count) {
  System system;
  system.contact = many_branches(count);
  system.omega = system.mean_normal_force = 1;
  system.friction = 0.3;
  system.normal_force_amplitude = 0.8;
  return system;
}

std::string refusal(const System& system, double velocity) try {
  steady_state(system, velocity);
  return "";
} catch (const ModelError& error) {
  return error.what();
}

// Newton's method carries n changes of n numbers through a stick and a slip, each by a full matrix
// at least, and solves n equations: 2 n^3 + n^3/3 products for each period that it takes a step
// from. It takes three steps at the least.
BOOST_AUTO_TEST_CASE(full_matrices_count) {
  constexpr std::size_t n = 300;
  System system = of_many_branches(n);
  const double velocity = 0.5 * sliding_threshold(system).drive_velocity;
  SharedEffort less_than_that(Effort::of_products(3 * (2 * n * n * n + n * n * n / 3)));
  system.effort = &less_than_that;
  BOOST_TEST(refusal(system, velocity).find("for all steady states") != std::string::npos);
  system.effort = nullptr;
  BOOST_TEST(refusal(system, velocity).empty());
}

// The matrices of one period alone are more than the bound; one is not even made for so many.
BOOST_AUTO_TEST_CASE(very_many_branches_are_refused_at_once) {
  const System system = of_many_branches(2000);
  const double velocity = 0.5 * sliding_threshold(system).drive_velocity;
  BOOST_TEST(refusal(system, velocity).find("too many branches") != std::string::npos);
  BOOST_TEST(refusal(of_many_branches(most_moving_branches + 1), 1).find("at most 4000") !=
             std::string::npos);
}

// A contact that opens: the search for their normal force, with a full matrix of changes, too.
BOOST_AUTO_TEST_CASE(the_normal_force_counts) {
  constexpr std::size_t n = 150;
  System system = of_many_branches(2);
  system.opening = {many_branches(n), 1, 1};
  SharedEffort less_than_a_period(Effort::of_products(2 * n * n * n));
  system.effort = &less_than_a_period;
  BOOST_CHECK_EXCEPTION(sliding_threshold(system), ModelError, [](const ModelError& error) {
    return std::string(error.what()).find("for all steady states") != std::string::npos;
  });
  system.effort = nullptr;
  BOOST_TEST(sliding_threshold(system).contact_velocity > 0);
  system.opening->network = many_branches(2000);
  BOOST_CHECK_EXCEPTION(sliding_threshold(system), ModelError, [](const ModelError& error) {
    return std::string(error.what()).find("normal network has too many branches") !=
           std::string::npos;
  });
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()
