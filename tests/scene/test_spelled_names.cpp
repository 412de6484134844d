// Names with letters beyond ASCII: refused wherever a scene has a name, in one line that says how
// to spell them, as not every language and system that gets them reads these.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <string>
#include <utility>

#include "base/spelled_names.hpp"
#include "problem/problem.hpp"
#include "support/refusal.hpp"

BOOST_AUTO_TEST_SUITE(test_spelled_names)

using namespace vcrit;

namespace {

/// NAME in a text stands for `name`.
std::string with(std::string text, const std::string& name) {
  for (std::size_t at = text.find("NAME"); at != text.npos; at = text.find("NAME"))
    text.replace(at, 4, name);
  return text;
}

}  // namespace

BOOST_AUTO_TEST_CASE(they_are_refused_wherever_a_scene_has_a_name) {
  for (const char* text :
       {"[contact]\nnormal = \"k0 | (NAME - c1)\"\npoisson = 0.3\n",
        "[contact]\nnormal = \"ladder(k0, NAME, 3)\"\npoisson = 0.3\n",
        "[contact]\nnormal = \"spring(NAME)\"\npoisson = 0.3\n",
        "[contact]\nnormal = \"k0\"\npoisson = \"NAME\"\n",
        "[contact]\nnormal = \"k0\"\ntangential = \"NAME\"\n",
        "[contact]\nnormal = \"k0\"\npoisson = 0.3\n[drive]\nnetwork = \"NAME\"\n",
        "[contact]\nnormal = \"k0\"\npoisson = 0.3\n[drive]\nnetwork = \"kd\"\n[body]\nmass = "
        "\"NAME\"\n",
        "[contact]\nnormal = \"k0\"\npoisson = 0.3\n[elements]\nk0 = \"2*NAME\"\n",
        "[contact]\nnormal = \"k0\"\npoisson = 0.3\n[elements]\nNAME = 2\n",
        "[contact]\nnormal = \"k0\"\npoisson = 0.3\n[elements]\n\"NAME\" = 2\n",
        "[contact]\nnormal = \"k0\"\npoisson = 0.3\n[networks.NAME]\nnetwork = \"k1\"\n",
        "[contact]\nnormal = \"k0\"\npoisson = 0.3\n[networks]\n\"NAME\" = \"k1\"\n",
        "[contact]\nnormal = \"own(k0)\"\npoisson = 0.3\n[networks.own]\narguments = [\"NAME\"]\n"
        "network = \"NAME\"\n",
        "[contact]\nnormal = \"own\"\npoisson = 0.3\n[networks.own]\nstiffness = \"NAME + "
        "s*c1\"\n"})
    for (const auto& [name, spelled] : {std::pair{"τ1", "write tau1"},
                                        {"k_Ω", "write k_Omega"},
                                        {"größe", "write groesse"},
                                        {"k₁", "write k1"},
                                        {"k\u0436", "digits and underscores"}}) {
      const std::string message =
          test::refusal([&] { parse_problem(with(text, name), "s.toml", {}).values(); });
      BOOST_TEST_CONTEXT(with(text, name)) {
        BOOST_TEST(test::has(message, std::string("name \"") + name + "\", with letters beyond"));
        BOOST_TEST(test::has(message, spelled));
        BOOST_TEST(std::count(message.begin(), message.end(), '\n') == 0);
      }
    }
}

BOOST_AUTO_TEST_CASE(signs_are_no_letters) {
  for (const char* text : {"k0", "k0 \u2212 c1", "k0\u00b7c1", "2 \u2013 3", "", "k0 \u00d7 2"})
    BOOST_TEST(name_beyond_ascii(text, 0).empty());
  BOOST_TEST(name_beyond_ascii("2*k_größe + 3", 4) == "k_größe");
  // A unit has its micro sign, and a text any letters.
  BOOST_CHECK_NO_THROW(
      parse_problem("title = \"größe τ\"\n[contact]\nnormal = \"k0\"\n"
                    "poisson = 0.3\n[oscillation]\namplitude = \"0.1 µm\"\n",
                    "s.toml", {}));
}

BOOST_AUTO_TEST_SUITE_END()
