// Where Eq. (24) holds on although the surfaces part: exactly where the contact point follows the
// normal deformation without memory.
#include "analysis/parting.hpp"

#include "analysis/equality.hpp"

#include <boost/test/unit_test.hpp>

#include "derivation/derivation.hpp"
#include "derivation/scenes.hpp"
#include "emit/generate.hpp"
#include "formula/symbols.hpp"
#include "formula/text.hpp"
#include "support/scene_text.hpp"

BOOST_AUTO_TEST_SUITE(test_parting_formula)

using namespace vcrit;
using namespace vcrit::symbolic;

namespace {

Scene parting(const std::string& contact, const std::string& drive = "",
              const std::string& mass = "", const std::string& rest = "") {
  return test::scene_of(contact + "\nseparation = true", drive, mass, rest);
}

}  // namespace

BOOST_AUTO_TEST_CASE(without_memory) {
  for (const Scene& scene :
       {parting("normal = \"k\"\ntangential = \"kt\""),
        parting("normal = \"k\"\ntangential = \"kt\"", "kd"),
        parting("normal = \"burgers(k1, c1, k2, c2)\"\npoisson = 0.3"),
        parting("normal = \"bridge\"\ntangential_ratio = 0.8", "", "", test::bridge_network)}) {
    const std::vector<Line> lines = parting_lines(derive(scene));
    BOOST_REQUIRE(lines.size() == 2u);
    BOOST_TEST(!lines[0].right.has(laplace()));
    BOOST_TEST((lines[1].right - derive(scene).critical_velocity).normal().is_zero());
  }
  BOOST_TEST(to_text(parting_lines(derive(parting("normal = \"k\"\ntangential = \"kt\"", "kd")))[0]
                         .right) == "-mu0*k*z*(kd + kt)/(kd*kt)");
}

BOOST_AUTO_TEST_CASE(with_memory) {
  for (const Scene& scene : {parting("normal = \"k | c\"\ntangential = \"kt | ct\""),
                             parting("normal = \"k | c\"\ntangential = \"kt\""),
                             parting("normal = \"k | c\"\npoisson = 0.3", "kd"),
                             parting("normal = \"k | c\"\ntangential_ratio = 1", "k | c"),
                             parting("normal = \"k\"\npoisson = 0.3", "kd", "m"),
                             parting("normal = \"prony(k0, k, tau, 20)\"\ntangential = \"kt\"")}) {
    BOOST_TEST(parting_lines(derive(scene)).empty());
    // No evaluator for what has no closed form; one as soon as the surfaces stay together.
    BOOST_CHECK_THROW(emit_header(derive(scene), "f"), ModelError);
    Scene closed = scene;
    closed.separation = false;
    BOOST_TEST(!emit_header(derive(closed), "f").empty());
  }
}

// Whether they touch where the indentation grows fastest is a question of numbers: no evaluator
// answers it, and the derivation with numbers does.
BOOST_AUTO_TEST_CASE(while_the_surfaces_touch) {
  const Scene apart = test::scene_of(test::slow_zener());
  const Scene touching = test::scene_of(test::slow_zener(), {{"c1", "0.1"}});
  BOOST_TEST(parting_lines(derive(apart)).empty());
  BOOST_TEST(parting_lines(derive(touching)).size() == 2u);
  for (const Scene& scene : {apart, touching})
    BOOST_CHECK_THROW(emit_header(derive(scene), "f"), ModelError);
  Scene unknown = apart;
  unknown.elements.front().second.reset();
  BOOST_REQUIRE(parting_lines(derive(unknown)).size() == 2u);
  BOOST_TEST(parting_lines(derive(unknown))[1].words.text().find("as long as they touch there") !=
             std::string::npos);
  // Nor is one formula of both equal to the other's v*.
  BOOST_CHECK_THROW(compare(apart, touching), ModelError);
}

BOOST_AUTO_TEST_SUITE_END()
