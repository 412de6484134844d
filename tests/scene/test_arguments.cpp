// Networks with arguments: what a call stands for, and what is wrong with the wrong ones.
#include <boost/test/unit_test.hpp>
#include <string>

#include "network/expression.hpp"
#include "scene/scene.hpp"
#include "support/refusal.hpp"

BOOST_AUTO_TEST_SUITE(test_arguments)

using namespace vcrit;
using test::has;

namespace {

Scene scene(const std::string& normal, const std::string& rest) {
  return parse_scene("[contact]\nnormal = \"" + normal + "\"\npoisson = 0.3\n" + rest, "s.toml");
}

/// The same network without arguments.
Network written(const std::string& normal, const std::string& rest = "") {
  return scene(normal, rest).normal;
}

std::string message(const std::string& normal, const std::string& rest) {
  return test::refusal([&] { scene(normal, rest); });
}

const std::string own =
    "[networks.own]\narguments = [\"a\", \"b\", \"c\"]\n"
    "network = \"spring(a) | spring(b) - c\"\n";

const std::string bridge =
    "[networks.bridge]\narguments = [\"k1\", \"c1\"]\nterminals = [\"a\", \"b\"]\n"
    "edges = [[\"k1\", \"a\", \"1\"], [\"c1\", \"a\", \"2\"], [\"k1\", \"1\", \"2\"], "
    "[\"kx\", \"1\", \"b\"], [\"c1\", \"2\", \"b\"]]\n";

}  // namespace

BOOST_AUTO_TEST_CASE(a_call_is_what_it_stands_for) {
  const Network expected = written("spring(E) | spring(F) - damper(eta)");
  BOOST_CHECK(written("own(E, F, eta)", own) == expected);
  BOOST_CHECK(written("kx - (own(E, F, eta) | cx)", own) ==
              written("kx - ((spring(E) | spring(F) - damper(eta)) | cx)"));
  BOOST_CHECK(written("own(E, E, eta)", own) == written("spring(E) | spring(E) - damper(eta)"));
}

// Names are put in all at once, and a name that is an argument is one in that network alone.
BOOST_AUTO_TEST_CASE(names_are_not_caught) {
  BOOST_CHECK(written("own(b, a, k0)", own) == written("spring(b) | spring(a) - damper(k0)"));
  const std::string around =
      own +
      "[networks.around]\narguments = [\"b\", \"a\"]\nnetwork = \"own(a, b, c1) - pad\"\n"
      "[networks.pad]\narguments = []\n";
  BOOST_TEST(has(message("around(x, y)", around), "s.toml:11:13: found arguments = an array"));
  const std::string plain =
      own +
      "[networks.around]\narguments = [\"b\", \"a\"]\nnetwork = \"own(a, b, c1) - (pad | "
      "spring(a))\"\n[networks.pad]\nnetwork = \"spring(a) | c\"\n";
  BOOST_CHECK(written("around(x, y) - pad", plain) ==
              written("(spring(y) | spring(x) - c1) - (spring(a) | c | spring(y)) - "
                      "(spring(a) | c)"));
}

BOOST_AUTO_TEST_CASE(graphs_and_arrays_take_arguments) {
  const Scene s = scene("bridge(E, eta) | bridge(F, eta)", bridge);
  const auto expected = [](const std::string& e) {
    return "[networks.g" + e + "]\nterminals = [\"a\", \"b\"]\nedges = [[\"spring(" + e +
           ")\", \"a\", \"1\"], [\"damper(eta)\", \"a\", \"2\"], [\"spring(" + e +
           ")\", \"1\", \"2\"], [\"kx\", \"1\", \"b\"], [\"damper(eta)\", \"2\", \"b\"]]\n";
  };
  BOOST_CHECK(s.normal == written("gE | gF", expected("E") + expected("F")));
  const std::string relaxing =
      "[networks.relaxing]\narguments = [\"k\", \"t\"]\nnetwork = \"prony(k9, k, t) | ladder(k, c, "
      "2)\"\n[elements]\nE = [1, 2]\nT = [3, 4]\n";
  BOOST_CHECK(written("relaxing(E, T)", relaxing) ==
              written("prony(k9, E, T, 2) | ladder(E, c, 2)"));
  BOOST_TEST(has(message("relaxing(E, T) - relaxing(k9, T)", relaxing), "\"k9\" as"));
}

// Its own network goes before one of the catalogue; a plain network does not take its place.
BOOST_AUTO_TEST_CASE(own_networks_go_first) {
  BOOST_CHECK(written("zener(x, y, z)",
                      "[networks.zener]\narguments = [\"k\", \"c\", \"d\"]\n"
                      "network = \"k - c - spring(d)\"\n") ==
              written("spring(x) - damper(y) - spring(z)"));
  BOOST_CHECK(written("zener(x, y, z) - zener", "[networks]\nzener = \"k | c\"\n") ==
              written("(spring(x) | spring(y) - damper(z)) - (k | c)"));
}

BOOST_AUTO_TEST_CASE(one_that_nobody_calls_is_read_for_its_errors) {
  const Scene s = scene("k0", own + "[elements]\nk0 = 1\n");
  BOOST_REQUIRE(s.warnings.size() == 1U);
  BOOST_TEST(has(s.warnings[0], "network \"own\" is not used by this scene"));
  BOOST_TEST(!s.settable.contains("a"));
  BOOST_TEST(has(message("k0", "[networks.own]\narguments = [\"a\"]\nnetwork = \"a\"\n"),
                 "s.toml:6:12: found element \"a\" of unknown kind"));
}

BOOST_AUTO_TEST_CASE(mistakes_are_named_with_their_place) {
  BOOST_TEST(
      has(message("own(E, F)", own), "s.toml:2:11: found own with 2 names; expected own(a, b, c)"));
  BOOST_TEST(
      has(message("k0 | own", own),
          "s.toml:2:16: found network \"own\" without its arguments; expected own(a, b, c)"));
  BOOST_TEST(has(message("own(E, F, 3)", own), "name \"3\""));
  BOOST_TEST(has(message("own(E, F, (G))", own), "the name of an element"));
  const auto of_arguments = [](const std::string& list) {
    return message("k0", "[networks]\npad = \"k0\"\n[networks.own]\narguments = " + list +
                             "\nnetwork = \"k0\"\n");
  };
  BOOST_TEST(has(of_arguments("[]"), "s.toml:7:13: found arguments = an array; expected"));
  BOOST_TEST(has(of_arguments("\"a\""), "found arguments = \"a\""));
  BOOST_TEST(has(of_arguments("[1]"), "s.toml:7:14: found argument 1"));
  BOOST_TEST(has(of_arguments("[\"a\", \"a\"]"), "s.toml:7:19: found argument \"a\" twice"));
  BOOST_TEST(
      has(of_arguments("[\"class\"]"), "argument \"class\", a name that is a reserved word"));
  BOOST_TEST(has(of_arguments("[\"pad\"]"), "\"pad\" as a network and as an argument"));
  BOOST_TEST(has(message("k0", "[networks.own]\narguments = [\"a\"]\nnet = \"k0\"\n"),
                 "unknown key \"net\""));
  BOOST_TEST(has(message("k0", "[networks.own]\narguments = [\"a\"]\nnetwork = 3\n"),
                 "s.toml:6:11: found network = 3"));
}

BOOST_AUTO_TEST_CASE(none_contains_itself) {
  BOOST_TEST(has(message("f(x)", "[networks.f]\narguments = [\"k\"]\nnetwork = \"k - f(k)\"\n"),
                 "s.toml:6:16: found network \"f\" inside itself"));
  BOOST_TEST(has(message("f(x)",
                         "[networks.f]\narguments = [\"k\"]\nnetwork = \"k - g\"\n"
                         "[networks]\ng = \"f(k0)\"\n"),
                 "network \"f\" inside itself"));
}

// Each calls the one before twice: a network of 2^30 elements is refused before it is built.
BOOST_AUTO_TEST_CASE(what_grows_by_calls_is_bounded) {
  std::string text = "[networks.f0]\narguments = [\"k\"]\nnetwork = \"k - k\"\n";
  for (int i = 1; i < 30; ++i)
    text += "[networks.f" + std::to_string(i) + "]\narguments = [\"k\"]\nnetwork = \"f" +
            std::to_string(i - 1) + "(k) | (c - f" + std::to_string(i - 1) + "(k))\"\n";
  BOOST_TEST(has(message("f29(x)", text), "elements"));
}

BOOST_AUTO_TEST_SUITE_END()
