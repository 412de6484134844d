// What follows from the kinds that a scene is of.
#include "rules/kinds.hpp"

#include <boost/test/unit_test.hpp>
#include <string>

#include "support/scene_text.hpp"

BOOST_AUTO_TEST_SUITE(test_kinds)

using namespace vcrit;
using namespace vcrit::rules;

namespace {

const std::string pressed_cone = "shape = \"cone\"\nangle = 0.1\n";

// K_n = 1 N/m at rest and at every frequency, u_z0 = 1 m.
test::SceneText on_a_spring(double amplitude) {
  return {.amplitude = amplitude, .elements = {{"kn", 1}}};
}

Problem problem_of(const test::SceneText& text) { return test::scene_of(text); }

}  // namespace

BOOST_AUTO_TEST_CASE(cells_move_below_an_indenter) {
  test::SceneText text = on_a_spring(0.5);
  BOOST_TEST(!cells_move(problem_of(text)));
  BOOST_TEST(!may_open(problem_of(text)));
  text.indenter = pressed_cone;
  BOOST_TEST(cells_move(problem_of(text)));
  BOOST_TEST(!cells_move_one_another(problem_of(text)));
  BOOST_TEST(may_open(problem_of(text)));
  text.network = "kd";
  text.elements.push_back({"kd", 1});
  BOOST_TEST(cells_move_one_another(problem_of(text)));
  text.indenter.clear();
  BOOST_TEST(!cells_move_one_another(problem_of(text)));
}

// The least force is K_n (u_z0 - du_z) = 1 - du_z.
BOOST_AUTO_TEST_CASE(contact_is_lost_where_the_scene_lets_it) {
  for (const double amplitude : {0.5, 2.0}) {
    test::SceneText text = on_a_spring(amplitude);
    BOOST_TEST(Facts(problem_of(text)).opens() == (amplitude > 1));
    BOOST_TEST(!Facts(problem_of(text)).loses_contact());
    text.separation = true;
    BOOST_TEST(may_open(problem_of(text)));
    BOOST_TEST(Facts(problem_of(text)).loses_contact() == (amplitude > 1));
  }
}

BOOST_AUTO_TEST_SUITE_END()
