// A friction curve is its points one by one, for less work.
#include "simulation/steady/curve.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "simulation/random_systems.hpp"
#include "simulation/steady/answers.hpp"
#include "simulation/steady/exact.hpp"
#include "simulation/steady/onset.hpp"

BOOST_AUTO_TEST_SUITE(test_curve)

namespace {

using namespace vcrit;
using namespace vcrit::simulation;

// From slow to faster than the threshold, in no order.
std::vector<double> speeds(const System& system) {
  const double threshold = sliding_threshold(system).drive_velocity;
  std::vector<double> result;
  for (int i = 0; i < 40; ++i) result.push_back(threshold * (0.03 + 0.028 * ((i * 17) % 40)));
  return result;
}

BOOST_AUTO_TEST_CASE(agrees_with_single_calls) {
  constexpr unsigned seed = 88;
  BOOST_TEST_MESSAGE("seed " << seed);
  for (unsigned i = 0; i < 60; ++i) {
    reference::RandomSystems systems(seed + i, i % 2 == 0 ? 1 : 6);
    const System system = systems.system();
    const std::vector<double> velocities = speeds(system);
    const std::vector<CurvePoint> curve = friction_curve(system, velocities);
    BOOST_TEST_REQUIRE(curve.size() == velocities.size());
    for (std::size_t j = 0; j < curve.size(); ++j) BOOST_TEST_CONTEXT("system " << i << " " << j) {
        BOOST_TEST_REQUIRE(curve[j].state.has_value());
        const SteadyState &point = *curve[j].state, single = steady_state(system, velocities[j]);
        const double difference = std::abs(point.friction_ratio - single.friction_ratio);
        BOOST_TEST(difference <= point.friction_ratio_error + single.friction_ratio_error);
        BOOST_TEST((point.regime == single.regime));
        BOOST_TEST(point.events.size() == single.events.size());
      }
  }
}

BOOST_AUTO_TEST_CASE(traces_fewer_periods_than_single_calls) {
  int continued = 0, afresh = 0;
  for (unsigned i = 0; i < 30; ++i) {
    reference::RandomSystems systems(300 + i, 2);
    const System system = systems.system();
    const double threshold = sliding_threshold(system).drive_velocity;
    Answers one_by_one(system), along(system);
    for (int j = 40; j > 0; --j) {
      one_by_one.at(0.024 * j * threshold, Start::sliding, 0);
      along.next(0.024 * j * threshold);
    }
    continued += along.traced_periods();
    afresh += one_by_one.traced_periods();
  }
  BOOST_TEST_MESSAGE(continued << " periods against " << afresh);
  // One period proves a cycle; it takes at least one more to find it.
  BOOST_TEST(2 * continued <= afresh + afresh / 2);
}

// K_d = m w^2: stick bounds the swing, but the faster the drive the less of it is left.
BOOST_AUTO_TEST_CASE(a_point_outside_the_model_says_why_and_stops_nothing) {
  System system;
  system.contact = {0, 0, {{2, 1.5}}};
  system.drive = Relaxation{1, 0, {}};
  system.mass = 1;
  system.omega = 1;
  system.friction = 0.5;
  system.mean_normal_force = 2;
  system.normal_force_amplitude = 1.6;
  // Below mu0 min F_n/eta = 0.2/3 the creeping contact sticks, and no swing arises.
  const std::vector<CurvePoint> curve = friction_curve(system, std::vector{1e9, 0.01, 0.2});
  BOOST_TEST(!curve[0].state.has_value());
  BOOST_TEST(curve[0].reason.find("resonance") != std::string::npos);
  BOOST_TEST_REQUIRE(curve[1].state.has_value());
  BOOST_TEST((curve[1].state->regime == Regime::stick));
  BOOST_TEST(curve[2].state.has_value(), curve[2].reason);
}

BOOST_AUTO_TEST_CASE(no_points) {
  BOOST_TEST(friction_curve(System{{1, 0, {}}, {}, {}, 1, 0.5, 1, 0.5}, {}).empty());
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()
