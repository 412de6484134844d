// A stiffness typed in as a rational function K(s): the springs and dampers that it stands for,
// against K(i omega) itself, and what is said of one that no springs and dampers have.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <complex>
#include <string>

#include "critical/certified.hpp"
#include "problem/problem.hpp"
#include "problem/variation.hpp"
#include "scene/scene.hpp"
#include "stiffness/dynamic_stiffness.hpp"
#include "support/refusal.hpp"

BOOST_AUTO_TEST_SUITE(test_rational_stiffness)

using namespace vcrit;
using test::has;

namespace {

/// The stiffness stands in line 11, its text from column 14 on.
std::string text(const std::string& stiffness, const std::string& more = "",
                 const std::string& normal = "pad") {
  return "[contact]\nnormal = \"" + normal +
         "\"\ntangential = \"kt\"\n[oscillation]\nangular_frequency = 1e5\namplitude = 1e-7\n"
         "indentation = 1e-5\n[friction]\ncoefficient = 0.5\n[networks.pad]\nstiffness = \"" +
         stiffness + "\"\n[elements]\nkt = 3e6\n" + more;
}

Problem problem(const std::string& stiffness, const std::string& more = "",
                const std::string& normal = "pad", const Settings& settings = {}) {
  return parse_problem(text(stiffness, more, normal), "s.toml", settings);
}

std::string message(const std::string& stiffness, const std::string& more = "",
                    const std::string& normal = "pad") {
  return test::refusal([&] { problem(stiffness, more, normal).values(); });
}

/// Whether K(i omega) of the network is that number.
bool is_stiffness(const std::string& stiffness, double omega, std::complex<double> expected) {
  const Problem made = problem(stiffness);
  const auto found = dynamic_stiffness(made->normal.network(), made.values(), omega);
  BOOST_TEST_MESSAGE(stiffness << ": " << found);
  return std::abs(found - expected) <= 2e-15 * std::abs(expected);
}

double velocity(const Problem& scene) { return certified_critical_velocity(scene).value; }

/// "1 + 1*s/(s + ...) + ...", with one more for each j.
template <class Pole>
std::string branches(int count, const Pole& pole) {
  std::string all = "1";
  for (int j = 0; j < count; ++j) all += "+" + std::to_string(j + 1) + "*s/(s+" + pole(j) + ")";
  return all;
}

}  // namespace

// Expected: the rational functions themselves at s = i omega, by mpmath with 50 digits.
BOOST_AUTO_TEST_CASE(the_network_has_the_stiffness) {
  BOOST_TEST(
      is_stiffness("(12e6*s + 8e9)/(s + 1e3)", 1e5, {11999600.0399960004, 39996.000399960004}));
  BOOST_TEST(is_stiffness("(s + 1)*(s + 3)/(s + 2)", 1e5, {1.9999999998, 100000.00001}));
  BOOST_TEST(is_stiffness("(s^2 + 4*s + 3)/(s + 2)", 2, {1.75, 2.25}));
  BOOST_TEST(
      is_stiffness("7*(s+0.5)*(s+2)*(s+4)*(s+6)*(s+8)*(s+10)/((s+1)*(s+3)*(s+5)*(s+7)*(s+9)"
                   "*(s+11))",
                   3, {2.9847389088261299215, 1.9472402090809798721}));
  BOOST_TEST(is_stiffness("(4*s^2 + 12*s + 2)/(s^2 + 4*s + 1)", 2,
                          {3.2054794520547945205, 0.54794520547945205479}));
  BOOST_TEST(is_stiffness("-(-3e6)", 1, 3e6));
  BOOST_TEST(is_stiffness("30*s", 1e3, {0, 3e4}));
}

// Poles -2 -+ sqrt(3), each with a spring of 1.
BOOST_AUTO_TEST_CASE(elements_are_named_after_the_network_and_exact_to_60_digits) {
  const Problem made = problem("(4*s^2 + 12*s + 2)/(s^2 + 4*s + 1) + 0.1*s");
  BOOST_TEST(made.values().at({"k0_pad"}) == 2);
  BOOST_TEST(made.values().at({"c_pad"}) == 0.1);
  BOOST_TEST(made.values().at({"k_pad", 1}) == 1);
  BOOST_TEST(made.values().at({"k_pad", 2}) == 1);
  BOOST_TEST(has(made->typed->at({"tau_pad", 1}).decimal,
                 "3.7320508075688772935274463415058723669428052538103806280558"));
  BOOST_TEST(has(made->typed->at({"tau_pad", 2}).decimal,
                 "0.2679491924311227064725536584941276330571947461896193719441"));
  BOOST_TEST(made.values().size() == 7 + 4);  // of the scene without the pad, and time constants
}

BOOST_AUTO_TEST_CASE(it_is_a_network_as_others_are) {
  const std::string zener = "(12e6*s + 8e9)/(s + 1e3)";
  const std::string same = "k0 = 8e6\nk1 = 4e6\nc1 = 4e3\n";
  const auto written = [&](const std::string& normal) { return problem("1", same, normal); };
  BOOST_TEST(velocity(problem(zener)) == velocity(written("k0 | (k1 - c1)")));
  BOOST_TEST(
      velocity(problem(zener, "c2 = 5\n", "pad - (kt | pad) - c2")) ==
      velocity(problem("1", same + "c2 = 5\n", "(k0 | (k1 - c1)) - (kt | k0 | (k1 - c1)) - c2")));
  BOOST_TEST(velocity(problem(zener, "", "pad", {{"k0_pad", "9 N/um"}})) ==
             velocity(problem("(13e6*s + 9e9)/(s + 1e3)")));
  BOOST_TEST(velocity(problem(zener).with({{{"k_pad", 1}, 2e6}})) ==
             velocity(problem("(10e6*s + 8e9)/(s + 1e3)")));
  // With a modulus in Pa, of the half-space below an indenter.
  const Problem below = parse_problem(
      "[contact]\nnormal = \"E\"\npoisson = 0.3\n[indenter]\nshape = \"flat\"\nradius = 1e-3\n"
      "[networks.E]\nstiffness = \"5e6 + 2e6*s/(s + 10)\"\n",
      "s.toml");
  BOOST_TEST(below->normal.network().form.index() == 2);  // parallel
}

// What is written in other ways, or with common factors, is the same function.
BOOST_AUTO_TEST_CASE(common_factors_do_not_matter) {
  const double expected = velocity(problem("8e6 + 4e6*s/(s + 1e3)"));
  for (const char* same : {"(12e6*s + 8e9)/(s + 1e3)", "(12e6*s + 8e9)*(s - 7)/((s + 1e3)*(s - 7))",
                           "8e6 + 4e6/(1 + 1e3/s)", "(8e6*(s+1e3)^3 + 4e6*s*(s+1e3)^2)/(s+1e3)^3",
                           "4e6 + 4e6 + 2e6*s/(s+1e3) + 2e6*s/(s+1e3) + s^3 - s^3",
                           "8e6 + 4e6*s/(s + 1e3) + s/(s^2+1) - s/(s^2+1)"})
    BOOST_TEST(velocity(problem(same)) == expected, same);
}

BOOST_AUTO_TEST_CASE(what_no_springs_and_dampers_have_is_refused_with_the_reason) {
  const std::string begin = "s.toml:11:14: found network \"pad\" with ";
  const std::string poles = "expected poles on the negative real axis, each once";
  const auto said = [&](const std::string& stiffness, const std::string& why) {
    const std::string words = message(stiffness);
    return has(words, begin + why);
  };
  BOOST_TEST(said("(4e6*s + 8e9)/(s + 1e3)",
                  "the pole s = -1000 rad/s, a Maxwell branch of stiffness -4e+06; expected "
                  "springs and dampers above 0; no network of springs and dampers has this K(s)"));
  BOOST_TEST(said("1/s", "a pole at s = 0; " + poles));
  BOOST_TEST(said("2 + s/(s + 1)^2", "a pole of K(s) that is repeated; " + poles));
  BOOST_TEST(said("2 + s/(s^2 + 2*s + 5)",
                  "2 of the 2 poles of K(s) off the negative real axis; " + poles));
  BOOST_TEST(said("2 + s/(s - 3)", "1 of the 1 poles of K(s) off"));
  BOOST_TEST(said("2 + s/(s + 1) + s/(s^2 + 1e-30)", "2 of the 3 poles of K(s) off"));
  BOOST_TEST(said("5e-3*s^2 + 8e6", "K(s) that grows as s^2"));
  BOOST_TEST(said("(s^4 + 1)/(s + 1)", "K(s) that grows as s^3"));
  BOOST_TEST(said("-8e6 + 9e6*s/(s + 1)", "the stiffness -8e+06 at rest"));
  BOOST_TEST(said("8 - 2*s", "K(s) = -2 s at high frequency"));
  BOOST_TEST(said("s - s", "K(s) = 0"));
  BOOST_TEST(said("1e300*1e300", "an element k0_pad = 1.00000e+600"));
}

// One branch among forty whose sign is wrong in the 22nd digit of the numerator.
BOOST_AUTO_TEST_CASE(passivity_is_decided_exactly) {
  const auto pole = [](int j) { return std::to_string(j + 1); };
  BOOST_TEST(message(branches(40, pole)) == "accepted");
  BOOST_TEST(has(message(branches(39, pole) + "-1e-22*s/(s+40.5)"),
                 "the pole s = -40.5 rad/s, a Maxwell branch of stiffness -1e-22"));
  BOOST_TEST(message(branches(39, pole) + "+1e-22*s/(s+40.5)") == "accepted");
  // The poles -1 -+ 1e-20 i, and -1 -+ 1e-20.
  BOOST_TEST(has(message("2+s*(s+1)/(s^2+2*s+1+1e-40)"), "2 of the 2 poles of K(s) off"));
  BOOST_TEST(message("2+s*(s+1)/(s^2+2*s+1-1e-40)") == "accepted");
}

BOOST_AUTO_TEST_CASE(what_cannot_be_read_is_refused_with_its_column) {
  BOOST_TEST(has(message("4e6 s"), "s.toml:11:18: found \"s\" in \"4e6 s\"; expected \"+\""));
  BOOST_TEST(has(message("4e6*?"), "s.toml:11:18: found \"?\" in \"4e6*?\"; expected s, a number"));
  BOOST_TEST(has(message(""), "s.toml:11:14: found the end in \"\""));
  BOOST_TEST(has(message("2*(s + 1"), "s.toml:11:16: found \"(\" without \")\""));
  BOOST_TEST(has(message("s + 1)"), "s.toml:11:19: found \")\""));
  BOOST_TEST(has(message("1/(s - s)"), "s.toml:11:16: found a division by 0"));
  BOOST_TEST(has(message("1e999"), "s.toml:11:14: found number 1e999"));
  BOOST_TEST(has(message("8 N/um"), "s.toml:11:16: found \"N\" in \"8 N/um\""));
  BOOST_TEST(has(message("s^-1"), "s.toml:11:16: found \"-1\""));
  BOOST_TEST(has(message("s^1000000000"), "s.toml:11:16: found \"1000000000\""));
  BOOST_TEST(has(message("1 + 0.12345678901234567890123456"), "s.toml:11:18: found number"));
  BOOST_TEST(has(message(std::string(300, '(') + "s"), "too many brackets in one another"));
}

BOOST_AUTO_TEST_CASE(its_size_is_limited) {
  const auto pole = [](int j) { return "1e" + std::to_string(j - 100); };
  BOOST_TEST(has(message(branches(200, pole)),
                 "very many terms or digits; expected polynomials of "
                 "degree 40 at most"));
  BOOST_TEST(has(message("(s+1)^40*(s+1)/((s+2)^40)"), "degree 40 at most"));
  std::string long_sum = "1";
  for (int i = 0; i < 3000; ++i) long_sum += "+1";
  BOOST_TEST(has(message(long_sum), "very many operations; expected at most 2000"));
  BOOST_TEST(has(message("((((1e300^40)^40)^40)^40)^40"), "very many terms or digits"));
}

BOOST_AUTO_TEST_CASE(its_elements_are_no_others) {
  BOOST_TEST(has(message("5e6", "k0_pad = 3\n"),
                 "s.toml:14:10: found \"k0_pad\", an element of network \"pad\" that its stiffness "
                 "gives; expected another name"));
  BOOST_TEST(has(message("5e6 + s/(s+1)", "", "pad | k_pad"),
                 "found \"k_pad\" as a spring; expected an array"));
  BOOST_TEST(has(test::refusal([&] {
                   parse_scene(
                       "[contact]\nnormal = \"pad(k1)\"\npoisson = 0.3\n[networks.pad]\n"
                       "stiffness = \"s\"\narguments = [\"k1\"]\n",
                       "s.toml");
                 }),
                 "unknown key \"arguments\" in [networks.pad]"));
  BOOST_TEST(has(test::refusal([&] {
                   parse_scene(
                       "[contact]\nnormal = \"pad\"\npoisson = 0.3\n[networks.pad]\n"
                       "stiffness = 5e6\n",
                       "s.toml");
                 }),
                 "s.toml:5:13: found"));
}

BOOST_AUTO_TEST_SUITE_END()
