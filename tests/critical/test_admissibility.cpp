// Admissibility (3), (4) and creep, against values worked out by hand.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>

#include "critical/admissibility.hpp"
#include "support/scene_text.hpp"

BOOST_AUTO_TEST_SUITE(test_admissibility)

using namespace vcrit;
using test::scene_of;

namespace {

bool mentions(const std::vector<std::string>& reasons, const std::string& part) {
  for (const std::string& reason : reasons)
    if (reason.find(part) != std::string::npos) return true;
  return false;
}

Scene kelvin(double amplitude) {
  // |K_n| = |3 + 2 i 2| = 5, K_n(0) = 3: the contact stays closed below du_z = 0.6.
  return scene_of(
      {.normal = "kn | cn", .amplitude = amplitude, .elements = {{"kn", 3}, {"cn", 2}}});
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_contact_stays_closed_below_the_limit) {
  BOOST_TEST(inadmissible_reasons(kelvin(0.599)).empty());
  BOOST_TEST(mentions(inadmissible_reasons(kelvin(0.601)), "the contact opens"));
}

BOOST_AUTO_TEST_CASE(the_amplitude_stays_below_the_indentation) {
  const Scene s = scene_of({.amplitude = 1, .elements = {{"kn", 3}}});
  BOOST_TEST(mentions(inadmissible_reasons(s), "not below the indentation"));
}

BOOST_AUTO_TEST_CASE(a_fluid_like_normal_network_carries_nothing) {
  const Scene s = scene_of({.normal = "kn - cn", .elements = {{"kn", 3}, {"cn", 1}}});
  BOOST_TEST(mentions(inadmissible_reasons(s), "no static load"));
}

BOOST_AUTO_TEST_CASE(solid_paths_do_not_creep) { BOOST_TEST(creep_velocity(kelvin(0.1)) == 0); }

BOOST_AUTO_TEST_CASE(fluid_paths_creep_by_their_viscosities) {
  // mu0 <F_n> = 0.5 * 3 = 1.5; tangential: Burgers, eta = c1 = 4; drive: eta = 2 + 1 (the damper
  // and the branch's k tau = c).
  const Scene s = scene_of({.tangential = "burgers(k1, c1, k2, c2)",
                            .network = "cd | (k3 - c3)",
                            .elements = {{"kn", 3},
                                         {"k1", 5},
                                         {"c1", 4},
                                         {"k2", 7},
                                         {"c2", 1},
                                         {"cd", 2},
                                         {"k3", 6},
                                         {"c3", 1}}});
  // A dozen roundings at most.
  BOOST_TEST(std::abs(creep_velocity(s) - 1.5 * (1.0 / 4 + 1.0 / 3)) < 1e-15);
}

BOOST_AUTO_TEST_SUITE_END()
