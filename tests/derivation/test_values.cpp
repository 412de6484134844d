// Derived formulas have the values of an independent nodal evaluation.
#include <boost/test/unit_test.hpp>

#include "analysis/exact_scene.hpp"
#include "derivation/derivation.hpp"
#include "formula/value.hpp"

BOOST_AUTO_TEST_SUITE(test_values)

using namespace vcrit;
using namespace vcrit::symbolic;

namespace {

constexpr unsigned seed = 20240611;

}  // namespace

// 500 scenes of up to 30 elements in each network, evaluated in CLN at 50 digits.
BOOST_AUTO_TEST_CASE(random_scenes) {
  BOOST_TEST_MESSAGE("seed " << seed);
  GiNaC::Digits = 50;
  test::RandomScenes random(seed, 4);
  int nested = 0, graphs = 0;
  for (int i = 0; i < 500; ++i) {
    Scene scene = random.scene(i % 30 + 1);
    test::round_ratio(scene);
    const Derivation derivation = derive(scene);
    nested += derivation.definitions.empty() ? 0 : 1;
    graphs += std::holds_alternative<Graph>(scene.normal.form) ? 1 : 0;
    const GiNaC::numeric derived =
        value_at(derivation.critical_velocity, derivation.definitions, test::exact_values(scene));
    const GiNaC::numeric nodal = test::number(test::critical_velocity_by_nodes(scene));
    // The nested form loses nothing but near resonance, which takes a digit for each decade of
    // distance; CLN carries 57 digits where 50 are asked for. The nodal values carry 250 digits, of
    // which each of 60 nodes at most may take three to four over 8 decades.
    BOOST_TEST(test::agreement(derived, nodal) > 45, "scene " << i << " of seed " << seed);
  }
  // Both forms of the formula and graphs are among them.
  BOOST_TEST(nested > 100);
  BOOST_TEST(nested < 490);
  BOOST_TEST(graphs > 50);
}

BOOST_AUTO_TEST_SUITE_END()
