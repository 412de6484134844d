// Where Eq. (24) holds on although the contact opens: exactly where the contact point follows the
// normal deformation without memory.
#include "analysis/separation.hpp"

#include "analysis/equality.hpp"

#include <boost/test/unit_test.hpp>

#include "derivation/derivation.hpp"
#include "derivation/scenes.hpp"
#include "emit/generate.hpp"
#include "formula/symbols.hpp"
#include "formula/text.hpp"
#include "support/scene_text.hpp"

BOOST_AUTO_TEST_SUITE(test_separation_formula)

using namespace vcrit;
using namespace vcrit::symbolic;

namespace {

Scene separating(const std::string& contact, const std::string& drive = "",
                 const std::string& mass = "", const std::string& rest = "") {
  return test::scene_of(contact + "\nseparation = true", drive, mass, rest);
}

}  // namespace

BOOST_AUTO_TEST_CASE(without_memory) {
  for (const Scene& scene :
       {separating("normal = \"k\"\ntangential = \"kt\""),
        separating("normal = \"k\"\ntangential = \"kt\"", "kd"),
        separating("normal = \"burgers(k1, c1, k2, c2)\"\npoisson = 0.3"),
        separating("normal = \"bridge\"\ntangential_ratio = 0.8", "", "", test::bridge_network)}) {
    const std::vector<Line> lines = separation_lines(derive(scene));
    BOOST_REQUIRE(lines.size() == 2u);
    BOOST_TEST(!lines[0].right.has(laplace()));
    BOOST_TEST((lines[1].right - derive(scene).critical_velocity).normal().is_zero());
  }
  BOOST_TEST(
      to_text(separation_lines(derive(separating("normal = \"k\"\ntangential = \"kt\"", "kd")))[0]
                  .right) == "-mu0*k*z*(kd + kt)/(kd*kt)");
}

BOOST_AUTO_TEST_CASE(with_memory) {
  for (const Scene& scene :
       {separating("normal = \"k | c\"\ntangential = \"kt | ct\""),
        separating("normal = \"k | c\"\ntangential = \"kt\""),
        separating("normal = \"k | c\"\npoisson = 0.3", "kd"),
        separating("normal = \"k | c\"\ntangential_ratio = 1", "k | c"),
        separating("normal = \"k\"\npoisson = 0.3", "kd", "m"),
        separating("normal = \"prony(k0, k, tau, 20)\"\ntangential = \"kt\"")}) {
    BOOST_TEST(separation_lines(derive(scene)).empty());
    // No evaluator for what has no closed form; one as soon as the contact stays closed.
    BOOST_CHECK_THROW(emit_header(derive(scene), "f"), ModelError);
    Scene closed = scene;
    closed.separation = false;
    BOOST_TEST(separation_lines(derive(closed)).empty());
    BOOST_TEST(!emit_header(derive(closed), "f").empty());
  }
}

// Whether it is closed where the indentation grows fastest is a question of numbers: no evaluator
// answers it, and the derivation with numbers does.
BOOST_AUTO_TEST_CASE(while_the_contact_is_closed) {
  const Scene open = test::scene_of(test::slow_zener());
  const Scene closed = test::scene_of(test::slow_zener(), {{"c1", "0.1"}});
  BOOST_TEST(separation_lines(derive(open)).empty());
  BOOST_TEST(separation_lines(derive(closed)).size() == 2u);
  for (const Scene& scene : {open, closed})
    BOOST_CHECK_THROW(emit_header(derive(scene), "f"), ModelError);
  Scene unknown = open;
  unknown.elements.front().second.reset();
  BOOST_REQUIRE(separation_lines(derive(unknown)).size() == 2u);
  BOOST_TEST(separation_lines(derive(unknown))[1].words.text().find(
                 "as long as the contact is closed there") != std::string::npos);
  // Nor is one formula of both equal to the other's v*.
  BOOST_CHECK_THROW(compare(open, closed), ModelError);
}

BOOST_AUTO_TEST_SUITE_END()
