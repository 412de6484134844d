// Admissibility (3), (4) and creep, against values worked out by hand.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>

#include "critical/admissibility.hpp"

BOOST_AUTO_TEST_SUITE(test_admissibility)

using namespace vcrit;

namespace {

Scene scene(const std::string& contact, double amplitude, const std::string& drive = {}) {
  return parse_scene(contact + drive + "[oscillation]\nangular_frequency = 2\namplitude = " +
                         std::to_string(amplitude) +
                         "\nindentation = 1\n[friction]\ncoefficient = 0.5\n",
                     "s.toml", {});
}

bool mentions(const std::vector<std::string>& reasons, const std::string& part) {
  for (const std::string& reason : reasons)
    if (reason.find(part) != std::string::npos) return true;
  return false;
}

Scene kelvin(double amplitude) {
  // |K_n| = |3 + 2 i 2| = 5, K_n(0) = 3: the contact stays closed below du_z = 0.6.
  return scene("[contact]\nnormal = \"kn | cn\"\npoisson = 0.3\n[elements]\nkn = 3\ncn = 2\n",
               amplitude);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_contact_stays_closed_below_the_limit) {
  BOOST_TEST(inadmissible_reasons(kelvin(0.599)).empty());
  BOOST_TEST(mentions(inadmissible_reasons(kelvin(0.601)), "the contact opens"));
}

BOOST_AUTO_TEST_CASE(the_amplitude_stays_below_the_indentation) {
  const Scene s = scene("[contact]\nnormal = \"kn\"\npoisson = 0.3\n[elements]\nkn = 3\n", 1);
  BOOST_TEST(mentions(inadmissible_reasons(s), "not below the indentation"));
}

BOOST_AUTO_TEST_CASE(a_fluid_like_normal_network_carries_nothing) {
  const Scene s =
      scene("[contact]\nnormal = \"kn - cn\"\npoisson = 0.3\n[elements]\nkn = 3\ncn = 1\n", 0.1);
  BOOST_TEST(mentions(inadmissible_reasons(s), "no static load"));
}

BOOST_AUTO_TEST_CASE(solid_paths_do_not_creep) { BOOST_TEST(creep_velocity(kelvin(0.1)) == 0); }

BOOST_AUTO_TEST_CASE(fluid_paths_creep_by_their_viscosities) {
  // mu0 <F_n> = 0.5 * 3 = 1.5; tangential: Burgers, eta = c1 = 4; drive: eta = 2 + 1 (the damper
  // and the branch's k tau = c).
  const Scene s = scene(
      "[contact]\nnormal = \"kn\"\ntangential = \"burgers(k1, c1, k2, c2)\"\n"
      "[elements]\nkn = 3\nk1 = 5\nc1 = 4\nk2 = 7\nc2 = 1\ncd = 2\nk3 = 6\nc3 = 1\n",
      0.1, "[drive]\nnetwork = \"cd | (k3 - c3)\"\n");
  // A dozen roundings at most.
  BOOST_TEST(std::abs(creep_velocity(s) - 1.5 * (1.0 / 4 + 1.0 / 3)) < 1e-15);
}

BOOST_AUTO_TEST_SUITE_END()
