// One v* below any indenter: the ratio of both half-space moduli against numbers from Hooke's law.
#include "analysis/half_space.hpp"

#include <boost/test/unit_test.hpp>

#include "derivation/derivation.hpp"
#include "derivation/scenes.hpp"
#include "formula/symbols.hpp"

BOOST_AUTO_TEST_SUITE(test_half_space_moduli)

using namespace vcrit;
using namespace vcrit::symbolic;

namespace {

Scene below(const std::string& normal, const std::string& poisson, const std::string& shape) {
  return test::scene_of("normal = \"" + normal + "\"\npoisson = " + poisson, "", "",
                        "[indenter]\n" + shape);
}

const std::string sphere = "shape = \"parabola\"\nradius = 0.01\n";

}  // namespace

// nu = 1/4: E* = 16/15 E, G = 2/5 E, G* = 32/35 E, their ratio 6/7.
BOOST_AUTO_TEST_CASE(one_ratio_everywhere) {
  const auto lines = half_space_lines(derive(below("zener(E0, E1, eta)", "0.25", sphere)));
  BOOST_REQUIRE(lines.size() == 4u);
  const GiNaC::ex E = quantity("E"), b = quantity("b");
  BOOST_TEST((lines[0].right - GiNaC::numeric(16, 15) * E * b).normal().is_zero());
  BOOST_TEST((lines[1].right - GiNaC::numeric(32, 35) * E * b).normal().is_zero());
  BOOST_TEST(lines[2].right.is_equal(GiNaC::numeric(6, 7)));
}

BOOST_AUTO_TEST_CASE(of_a_scene_without_an_indenter) {
  Scene scene = below("kelvin(E, eta)", "\"nu\"", sphere);
  scene.indenter.reset();
  BOOST_CHECK_THROW(half_space_lines(derive(scene)), InputError);
}

BOOST_AUTO_TEST_CASE(one_critical_velocity_for_all_shapes) {
  const Scene with_sphere = below("kelvin(E, eta)", "\"nu\"", sphere);
  const GiNaC::ex expected = half_space_lines(derive(with_sphere)).back().right;
  BOOST_TEST(!expected.has(quantity("E")));
  for (const char* shape : {"shape = \"cone\"\n", "shape = \"flat\"\nradius = 1\n",
                            "shape = \"power\"\nexponent = 4\n"}) {
    const Scene other = below("burgers(E1, eta1, E2, eta2)", "\"nu\"", shape);
    BOOST_TEST((derive(other).critical_velocity - expected).normal().is_zero());
  }
}

BOOST_AUTO_TEST_SUITE_END()
