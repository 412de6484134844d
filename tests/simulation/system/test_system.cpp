// Scenes as the simulator sees them.
#include "simulation/system/system.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "base/errors.hpp"
#include "simulation/steady/exact.hpp"
#include "simulation/steady/onset.hpp"
#include "support/scene_text.hpp"

BOOST_AUTO_TEST_SUITE(test_system)

namespace {

using namespace vcrit;
using namespace vcrit::simulation;

System system_from(test::SceneText text) {
  text.indentation = 0.5;
  text.coefficient = 0.25;
  return system_of(test::scene_of(text));
}

}  // namespace

BOOST_AUTO_TEST_CASE(isotropic_kelvin_contact) {
  const System s =
      system_from({.normal = "k | c", .tangential_ratio = 0.5, .elements = {{"k", 8}, {"c", 3}}});
  BOOST_TEST(s.contact.equilibrium == 4.0);
  BOOST_TEST(s.contact.damper == 1.5);
  BOOST_TEST(!s.drive.has_value());
  BOOST_TEST(!s.mass.has_value());
  BOOST_TEST(s.omega == 2.0);
  BOOST_TEST(s.friction == 0.25);
  BOOST_TEST(s.mean_normal_force == 4.0);
  BOOST_TEST(std::abs(s.normal_force_amplitude - std::complex<double>(0.8, 0.6)) < 1e-16 * 4);
}

// Drive and body as far as the scene has them. v* = mu0 w du_z k_n/k_t |k_t + D|/|D|, D = k_d - m
// w^2: 0.25 x 2 x 0.1 x (8/2) x |2 - 2|... with D = 6 - 1 x 4 = 2: (2 + 2)/2 = 2, so v* = 0.4.
BOOST_AUTO_TEST_CASE(drive_and_mass) {
  const System s = system_from({.tangential = "kt",
                                .network = "kd",
                                .mass = 1,
                                .elements = {{"kn", 8}, {"kt", 2}, {"kd", 6}}});
  BOOST_TEST(s.contact.equilibrium == 2.0);
  BOOST_TEST(s.drive.value().equilibrium == 6.0);
  BOOST_TEST(s.mass.value() == 1.0);
  BOOST_TEST(std::abs(sliding_threshold(s).contact_velocity - 0.4) < 4e-16);
}

BOOST_AUTO_TEST_CASE(outside_the_model) {
  const auto with = [](const char* normal, double amplitude) {
    return system_from(
        {.normal = normal, .amplitude = amplitude, .elements = {{"k", 8}, {"c", 30}}});
  };
  // du_z |K_n| = 0.1 |8 + 60 i| = 6.05 N against a mean of 4 N.
  BOOST_CHECK_THROW(with("k | c", 0.1), ModelError);
  BOOST_CHECK_THROW(with("k | c", 0.6), ModelError);
  BOOST_CHECK_THROW(with("k - c", 0.1), ModelError);
  BOOST_CHECK_THROW(system_from({.normal = "k | c", .elements = {{"k", 8}}}), InputError);
}

// Beyond du_z |K_n| = K_n(0) u_z0 the contact opens; up to it, the very border included, the force
// is one sinusoid.
BOOST_AUTO_TEST_CASE(a_contact_that_may_open) {
  const auto with = [](double amplitude) {
    return system_from({.separation = true, .amplitude = amplitude, .elements = {{"kn", 8}}});
  };
  BOOST_TEST(!with(0.49).opening.has_value());
  const System border = with(0.5);
  BOOST_TEST(!border.opening.has_value());
  BOOST_TEST(std::abs(border.normal_force_amplitude) == border.mean_normal_force);
  // 2e-13 of the amplitude, a thousand roundings, are above the border.
  BOOST_TEST(with(0.5000000000001).opening.has_value());
  BOOST_TEST(with(0.50000001).opening.has_value());
  const System open = with(0.6);
  BOOST_REQUIRE(open.opening.has_value());
  BOOST_TEST(open.opening->mean == 0.5);
  BOOST_TEST(open.opening->amplitude == 0.6);
  BOOST_TEST(open.opening->network.equilibrium == 8);
  BOOST_CHECK_THROW(system_from({.normal = "k - c",
                                 .separation = true,
                                 .amplitude = 0.6,
                                 .elements = {{"k", 8}, {"c", 1}}}),
                    ModelError);
}

// The flat punch at the border, D = 1: figures right to 1e-8 in each digit given.
BOOST_AUTO_TEST_CASE(flat_punch_at_the_border) {
  const System system = system_from(
      {.tangential_ratio = 1, .separation = true, .amplitude = 0.5, .elements = {{"kn", 8}}});
  const double critical = 0.25 * 2 * 0.5;
  const std::pair<double, double> table[] = {{0.1, 0.24282864},
                                             {0.25, 0.50811840},
                                             {0.5, 0.79854780},
                                             {0.75, 0.95276173},
                                             {0.9, 0.99268919}};
  for (const auto& [ratio, friction] : table)
    for (const Start start : {Start::sliding, Start::rest})
      BOOST_TEST(std::abs(steady_state(system, ratio * critical, start).friction_ratio -
                          friction) <= 1e-8);
}

BOOST_AUTO_TEST_SUITE_END()
