// Friction of any scene: that of its contact, or of all cells below its indenter.
#include "answers/friction.hpp"
#include "scene/scene.hpp"
#include "support/scene_text.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_friction)

using namespace vcrit;

namespace {

constexpr double amplitude_ratio = 0.5;

// omega = mu0 = 1, elastic: v* = du_z k_n/k_t of a flat punch as of one contact.
Scene elastic(const std::string& indenter) {
  return test::scene_of({.normal = "spring(E)",
                         .poisson = 0,
                         .indenter = indenter,
                         .angular_frequency = 1,
                         .amplitude = 0.5,
                         .coefficient = 1,
                         .elements = {{"E", 1}}});
}

const std::string punch = "shape = \"flat\"\nradius = 1.0\n";

}  // namespace

// All cells of a flat punch move alike, as one contact does; both to 1e-9.
BOOST_AUTO_TEST_CASE(a_flat_punch_is_one_contact) {
  const SteadyFriction one(elastic("")), many(elastic(punch));
  for (const double part : {0.2, 0.5, 0.9, 1.5}) {
    const double velocity = part * amplitude_ratio;
    BOOST_TEST(std::abs(one.at(velocity).friction_ratio - many.at(velocity).friction_ratio) < 2e-9);
  }
  BOOST_TEST((one.at(1.5 * amplitude_ratio).regime == simulation::Regime::sliding));
}

BOOST_AUTO_TEST_CASE(a_curve_has_the_friction_of_each_speed) {
  const std::vector<double> velocities{0.1, 0.4, 0.3};
  for (const std::string& indenter : {std::string(), punch}) {
    const SteadyFriction friction(elastic(indenter));
    std::vector<double> found(velocities.size());
    friction.curve(velocities, [&](std::size_t i, const simulation::PassingPoint& point) {
      BOOST_REQUIRE(point.state != nullptr);
      found[i] = point.state->friction_ratio;
    });
    for (std::size_t i = 0; i < velocities.size(); ++i)
      BOOST_TEST(std::abs(found[i] - friction.at(velocities[i]).friction_ratio) < 2e-9);
  }
}

BOOST_AUTO_TEST_CASE(a_scene_without_a_motion_is_refused) {
  Scene scene = elastic("");
  scene.amplitude.value = 2;
  BOOST_CHECK_THROW(SteadyFriction{scene}, ModelError);
}

BOOST_AUTO_TEST_SUITE_END()
