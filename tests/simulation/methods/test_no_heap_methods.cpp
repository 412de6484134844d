// Time steps of the other methods take no memory from the heap: a period of many steps takes as
// little as one of few.
#include <boost/test/unit_test.hpp>

#include "simulation/methods/moreau.hpp"
#include "simulation/methods/switching.hpp"
#include "simulation/methods/tanh_friction.hpp"
#include "support/heap.hpp"

BOOST_AUTO_TEST_SUITE(test_no_heap_methods)

namespace {

using namespace vcrit;
using namespace vcrit::simulation;
using namespace vcrit::simulation::methods;

// Contact and drive of two branches each, and a body.
System with_body() {
  System system;
  system.contact = {1, 0.1, {{0.5, 0.3}, {0.2, 3}}};
  system.drive = Relaxation{0.3, 0.05, {{0.2, 1}, {0.1, 10}}};
  system.mass = 2;
  system.omega = 1;
  system.friction = 0.5;
  system.mean_normal_force = 2;
  system.normal_force_amplitude = 1.8;
  return system;
}

constexpr double velocity = 0.3;

// Of one period, after one to warm up.
long requests(PeriodMap& map) {
  const MapState begin = map.run(map.start(Start::sliding)).end;
  return test::heap_requests([&] { map.run(begin); });
}

long with_tolerance(Method method, double tolerance) {
  MethodOptions options;
  options.tolerance = tolerance;
  return requests(*switching_map(method, with_body(), velocity, options));
}

}  // namespace

// The motion of the tests below has events, whose number is the same for all settings.
BOOST_AUTO_TEST_CASE(the_motion_sticks_and_slips) {
  MethodOptions options;
  const auto map = switching_map(Method::rk8pd, with_body(), velocity, options);
  BOOST_TEST(map->run(map->run(map->start(Start::sliding)).end).events.size() == 2U);
}

BOOST_AUTO_TEST_CASE(steps_of_moreau) {
  const auto with_steps = [](int steps) {
    MethodOptions options;
    options.steps_per_period = steps;
    return requests(*moreau_map(with_body(), velocity, options));
  };
  BOOST_TEST(with_steps(100'000) == with_steps(1000));
}

// A hundred thousand times more accurate: with orders of 4 and 8 some ten and four times as many
// steps. msbdf is left out: GSL's own LU decomposition takes a permutation from the heap each time.
BOOST_AUTO_TEST_CASE(steps_of_adaptive_integrators) {
  for (const Method method : {Method::rkf45, Method::rk8pd})
    BOOST_TEST(with_tolerance(method, 1e-11) == with_tolerance(method, 1e-6));
}

BOOST_AUTO_TEST_CASE(steps_with_smooth_friction) {
  const auto with = [](double tolerance) {
    MethodOptions options;
    options.tolerance = tolerance;
    return requests(*tanh_map(with_body(), velocity, options));
  };
  BOOST_TEST(with(1e-11) == with(1e-6));
}

BOOST_AUTO_TEST_SUITE_END()
