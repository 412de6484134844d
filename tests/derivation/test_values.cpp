// Derived formulas have the values of an independent nodal evaluation.
#include <boost/test/unit_test.hpp>

#include "derivation/derivation.hpp"
#include "derivation/values.hpp"
#include "formula/symbols.hpp"
#include "formula/value.hpp"
#include "support/nodal.hpp"
#include "support/random_scene.hpp"

using namespace vcrit;
using namespace vcrit::symbolic;

namespace {

constexpr unsigned seed = 20240611;

GiNaC::numeric number(const test::Real& value) {
  return GiNaC::numeric(value.str(120, std::ios::scientific).c_str());
}

/// Digits in which two numbers agree.
double agreement(const GiNaC::numeric& a, const GiNaC::numeric& b) {
  if (a.is_equal(b)) return 1000;
  return -(GiNaC::log(GiNaC::abs((a - b) / b)) / GiNaC::log(GiNaC::numeric(10))).to_double();
}

}  // namespace

BOOST_AUTO_TEST_CASE(random_scenes) {
  BOOST_TEST_MESSAGE("seed " << seed);
  GiNaC::Digits = 150;
  test::RandomScenes random(seed, 4);
  int nested = 0, graphs = 0;
  for (int i = 0; i < 100; ++i) {
    Scene scene = random.scene(i % 12 + 1);
    test::round_ratio(scene);
    const Derivation derivation = derive(scene);
    nested += derivation.definitions.empty() ? 0 : 1;
    graphs += std::holds_alternative<Graph>(scene.normal.form) ? 1 : 0;
    const GiNaC::numeric derived =
        value_at(derivation.critical_velocity, derivation.definitions, test::exact_values(scene));
    const GiNaC::numeric nodal = number(test::critical_velocity_by_nodes(scene));
    // 24 terms over 8 decades each lose at most some 24*8/2 of the 150 digits carried (multiplied
    // out, the nested form loses none); the nodal values carry 250.
    BOOST_TEST(agreement(derived, nodal) > 50, "scene " << i << " of seed " << seed);
  }
  // Both forms of the formula and graphs are among them.
  BOOST_TEST(nested > 10);
  BOOST_TEST(nested < 90);
  BOOST_TEST(graphs > 5);
}
