// Scenes as the simulator sees them.
#include "simulation/system/system.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "base/errors.hpp"
#include "simulation/steady/exact.hpp"
#include "simulation/steady/onset.hpp"

namespace {

using namespace vcrit;
using namespace vcrit::simulation;

std::string scene(const std::string& contact, const std::string& rest,
                  const std::string& amplitude = "0.1") {
  return "[contact]\n" + contact +
         "\n[oscillation]\nangular_frequency = 2.0\namplitude = " + amplitude +
         "\nindentation = 0.5\n[friction]\ncoefficient = 0.25\n" + rest;
}

System system_from(const std::string& text) { return system_of(parse_scene(text, "test.toml")); }

}  // namespace

BOOST_AUTO_TEST_CASE(isotropic_kelvin_contact) {
  const System s = system_from(
      scene("normal = \"k | c\"\ntangential_ratio = 0.5", "[elements]\nk = 8.0\nc = 3.0\n"));
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
  const System s = system_from(scene(
      "normal = \"k\"\ntangential = \"kt\"",
      "[drive]\nnetwork = \"kd\"\n[body]\nmass = 1.0\n[elements]\nk = 8.0\nkt = 2.0\nkd = 6.0\n"));
  BOOST_TEST(s.contact.equilibrium == 2.0);
  BOOST_TEST(s.drive.value().equilibrium == 6.0);
  BOOST_TEST(s.mass.value() == 1.0);
  BOOST_TEST(std::abs(sliding_threshold(s).contact_velocity - 0.4) < 4e-16);
}

BOOST_AUTO_TEST_CASE(outside_the_model) {
  const std::string kelvin = "normal = \"k | c\"\npoisson = 0.3";
  const std::string elements = "[elements]\nk = 8.0\nc = 30.0\n";
  // du_z |K_n| = 0.1 |8 + 60 i| = 6.05 N against a mean of 4 N.
  BOOST_CHECK_THROW(system_from(scene(kelvin, elements)), ModelError);
  BOOST_CHECK_THROW(system_from(scene(kelvin, elements, "0.6")), ModelError);
  BOOST_CHECK_THROW(system_from(scene("normal = \"k - c\"\npoisson = 0.3", elements)), ModelError);
  BOOST_CHECK_THROW(system_from(scene(kelvin, "[elements]\nk = 8.0\n")), InputError);
}
