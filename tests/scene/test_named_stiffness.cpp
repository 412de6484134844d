// A stiffness K(s) of names: the springs and dampers that it stands for, against the network
// written out, against K(i omega) itself, and what is said of one that is not passive at all
// values.
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

BOOST_AUTO_TEST_SUITE(test_named_stiffness)

using namespace vcrit;
using test::has;

namespace {

/// The stiffness stands in line 11, its text from column 14 on.
std::string text(const std::string& stiffness, const std::string& elements,
                 const std::string& normal = "pad") {
  return "[contact]\nnormal = \"" + normal +
         "\"\ntangential = \"kt\"\n[oscillation]\nangular_frequency = 1e5\namplitude = 1e-7\n"
         "indentation = 1e-5\n[friction]\ncoefficient = 0.5\n[networks.pad]\nstiffness = \"" +
         stiffness + "\"\n[elements]\nkt = 3e6\n" + elements;
}

Problem problem(const std::string& stiffness, const std::string& elements,
                const std::string& normal = "pad", const Settings& settings = {}) {
  return parse_problem(text(stiffness, elements, normal), "s.toml", settings);
}

std::string message(const std::string& stiffness, const std::string& elements = "") {
  return test::refusal([&] { problem(stiffness, elements).values(); });
}

using Complex = std::complex<double>;

/// Whether K(i omega) of the network is that number, to rounding: some ten operations of a few
/// units in the last place each, for positive numbers.
bool is_stiffness(const std::string& stiffness, const std::string& elements, Complex expected) {
  const Problem made = problem(stiffness, elements);
  const Complex found = dynamic_stiffness(made->normal.network(), made.values(), 1e5);
  BOOST_TEST_MESSAGE(stiffness << ": " << found << ", " << expected);
  return std::abs(found - expected) <= 1e-14 * std::abs(expected);
}

double velocity(const Problem& scene) { return certified_critical_velocity(scene).value; }

const std::string numbers = "k0 = 8e6\nk1 = 4e6\nc1 = \"30 N s/m\"\ntau = \"7.5 us\"\nr = 0.5\n";
const Complex s(0, 1e5);

}  // namespace

BOOST_AUTO_TEST_CASE(the_network_has_the_stiffness) {
  const double k0 = 8e6, k1 = 4e6, c1 = 30, tau = 7.5e-6, r = 0.5;
  const auto is = [](const std::string& stiffness, Complex expected) {
    return is_stiffness(stiffness, numbers, expected);
  };
  BOOST_TEST(is("k0 + k1*tau*s/(1 + tau*s)", k0 + k1 * tau * s / (1. + tau * s)));
  BOOST_TEST(is("k0*(1 + 3*tau*s)/(1 + tau*s)", k0 * (1. + 3 * tau * s) / (1. + tau * s)));
  BOOST_TEST(is("k0*(1 + tau*(1+r)*s)/(1 + tau*s)", k0 * (1. + tau * 1.5 * s) / (1. + tau * s)));
  BOOST_TEST(is("(k0*k1 + (k0 + k1)*c1*s)/(k1 + c1*s)", k0 + k1 * c1 * s / (k1 + c1 * s)));
  BOOST_TEST(is("k0*(k1 + c1*s)/(k0 + k1 + c1*s)", k0 * (k1 + c1 * s) / (k0 + k1 + c1 * s)));
  BOOST_TEST(is("c1*s + 1/(1/k1 + 1/(c1*s))", c1 * s + 1. / (1 / k1 + 1. / (c1 * s))));
  BOOST_TEST(is("k0 + k1*tau*s/(1 + tau*s) + r*k1*c1*s/(k0 + c1*s)",
                k0 + k1 * tau * s / (1. + tau * s) + r * k1 * c1 * s / (k0 + c1 * s)));
  // Kelvin elements one behind the other: in K(s) a difference would be squared, in 1/K(s) there is
  // none. Then with a spring, with a damper, three of them with both, and as one quotient.
  const Complex first = k0 + c1 * s, second = k1 + r * c1 * s, third = k1 + k0 * tau * s;
  BOOST_TEST(is("1/(1/(k0 + c1*s) + 1/(k1 + r*c1*s))", 1. / (1. / first + 1. / second)));
  BOOST_TEST(
      is("(k0 + c1*s)*(k1 + r*c1*s)/((k0 + k1) + (c1 + r*c1)*s)", 1. / (1. / first + 1. / second)));
  BOOST_TEST(
      is("1/(1/k1 + 1/(k0 + c1*s) + 1/(k1 + r*c1*s))", 1. / (1. / k1 + 1. / first + 1. / second)));
  BOOST_TEST(is("1/(1/(c1*s) + 1/(k0 + c1*s) + 1/(k1 + r*c1*s))",
                1. / (1. / (c1 * s) + 1. / first + 1. / second)));
  BOOST_TEST(is("1/(1/k0 + 1/(c1*s) + 1/(k0 + c1*s) + 1/(k1 + r*c1*s) + 1/(k1 + k0*tau*s))",
                1. / (1. / k0 + 1. / (c1 * s) + 1. / first + 1. / second + 1. / third)));
  // Numbers alone in an element: in SI units, of a pole as well.
  BOOST_TEST(is("8e6 + k1*s/(s + 1e5)", 8e6 + k1 * s / (s + 1e5)));
}

// Elements are expressions of the names, so that these are the scene's numbers.
BOOST_AUTO_TEST_CASE(it_is_a_network_of_the_names) {
  const std::string zener = "(k0*k1 + (k0 + k1)*c1*s)/(k1 + c1*s)";
  const auto written = [](const Settings& settings) {
    return problem("k0", numbers, "k0 | (k1 - c1)", settings);
  };
  // Both are the double nearest to the exact value.
  BOOST_TEST(velocity(problem(zener, numbers)) == velocity(written({})));
  for (const auto& [name, value] : {std::pair("k0", "5e6"), {"k1", "9 N/um"}, {"c1", "11"}})
    BOOST_TEST(velocity(problem(zener, numbers, "pad", {{name, value}})) ==
                   velocity(written({{name, value}})),
               name);
  const Problem made = problem(zener, numbers);
  BOOST_TEST(made.values().contains({"k1"}));
  BOOST_TEST(!made.values().contains({"k0_pad"}));
  BOOST_TEST(velocity(made.with({{{"k1"}, 1e6}})) == velocity(written({{"k1", "1e6"}})));
  BOOST_TEST(velocity(made.with({{{"c1"}, 55.5}})) == velocity(written({{"c1", "55.5"}})));
  // Elements in series are those that were typed in.
  BOOST_TEST(velocity(problem("1/(1/(k0 + c1*s) + 1/(k1 + r*c1*s))", numbers)) ==
             velocity(problem("k0", numbers + "c2 = \"r*c1\"\n", "(k0 | c1) - (k1 | c2)")));
  // A spring of value 0 is left out, with its damper.
  BOOST_TEST(velocity(problem("k0 + k1*tau*s/(1 + tau*s)", numbers, "pad", {{"k1", "0"}})) ==
             velocity(problem("k0", numbers)));
}

// What [elements] makes of others is put in first: k0 (tau1 - tau)/tau is r k0 here.
BOOST_AUTO_TEST_CASE(expressions_and_other_names_of_elements_are_followed) {
  const std::string more =
      numbers + "tau1 = \"tau*(1 + r)\"\nk = [\"k0\", 2e6]\ncalled = \"tau\"\n";
  BOOST_TEST(velocity(problem("k0*(1 + tau1*s)/(1 + tau*s)", more)) ==
             velocity(problem("k0 + r*k0*tau*s/(1 + tau*s)", more)));
  BOOST_TEST(velocity(problem("k[1] + k[2]*called*s/(1 + called*s)", more)) ==
             velocity(problem("k0 + 2e6*tau*s/(1 + tau*s)", more)));
  const Scene made = parse_scene(text("k0*(1 + tau1*s)/(1 + tau*s)", more), "s.toml");
  for (const std::string& warning : made.warnings)
    BOOST_TEST((warning.find("tau") == std::string::npos), warning);
}

BOOST_AUTO_TEST_CASE(what_is_not_passive_at_all_values_is_refused_with_the_reason) {
  const std::string begin = "s.toml:11:14: found network \"pad\" with ";
  const auto said = [&](const std::string& stiffness, const std::string& why) {
    return has(message(stiffness), begin + why);
  };
  BOOST_TEST(said("k*(1 + tau*s)/(1 + 2*tau*s)",
                  "a Maxwell branch of stiffness -k/2; expected springs and dampers above 0; no "
                  "network of springs and dampers has this K(s)"));
  BOOST_TEST(said("k*(1 + tau1*s)/(1 + tau2*s)",
                  "a Maxwell branch of stiffness (tau1 - tau2)*k/tau2; expected springs, dampers "
                  "and times that are above 0 at all values of its names; make the larger one"));
  BOOST_TEST(said("k/(1 - tau*s)", "a relaxation time -tau"));
  BOOST_TEST(said("k - c*s", "a damper at high frequency, -c"));
  BOOST_TEST(said("k0 - k1", "the stiffness at rest k0 - k1"));
  BOOST_TEST(said("k0 - k1/(a^3 + b^3)",
                  "the stiffness at rest (k0*a^3 + k0*b^3 - k1)/(a^3 + b^3); expected"));
  BOOST_TEST(said("k/(1 + a*s + b*s^2)", "the factor "));
  BOOST_TEST(said("k/(1 + a*s + b*s^2)", "the factor s^2*b + s*a + 1 of its denominator, whose"));
  BOOST_TEST(said("k0 + k*s/(1 + tau*s)^2", "the factor s*tau + 1 of its denominator, 2 times"));
  BOOST_TEST(said("k/s", "a pole at s = 0"));
  // In series as in parallel: one Kelvin element less another.
  BOOST_TEST(said("1/(1/(k1 + c1*s) - 1/(k2 + c2*s))", ""));
  BOOST_TEST(said("k*s^2/(c1 + tau*s)", ""));
  BOOST_TEST(said("k + m*s^2", "K(s) that grows as s^2"));
  BOOST_TEST(said("k - k", "K(s) = 0"));
}

BOOST_AUTO_TEST_CASE(units_and_circles_are_looked_at) {
  BOOST_TEST(has(message("k0 + k1*c1*s/(1 + c1*s)", numbers), "s.toml:11:13: found "));
  BOOST_TEST(has(message("k0 + c1", numbers), "found k0_pad = \"k0 + c1\", a damping"));
  BOOST_TEST(has(message("k0*(1 + a*s)", "k0 = 1\na = \"2*b\"\nb = \"a/3\"\n"),
                 "expressions in a circle: a -> b -> a"));
  BOOST_TEST(has(message("k_pad*s/(s + 1)"), "\"k_pad\", an element of network \"pad\" that its"));
  BOOST_TEST(has(message("k0 + 1/(k1 - k1)"), "s.toml:11:21: found a division by 0"));
  BOOST_TEST(has(message("k0 + while"), "s.toml:11:19: found name \"while\", which"));
  BOOST_TEST(has(message("k0 + k[0]"), "the number of an entry, from 1"));
}

BOOST_AUTO_TEST_CASE(its_size_is_limited) {
  std::string many = "k0";
  for (int i = 1; i <= 12; ++i) {
    const std::string j = std::to_string(i);
    many += " + k" + j + "*t" + j + "*s/(1 + t" + j + "*s)";
  }
  BOOST_TEST(has(message(many), "very many terms or digits"));
  BOOST_TEST(has(message("k0*(1 + s)^40/(1 + k1*s)^40*(s + 2)^40/(s + k1)^40*s"),
                 "very many terms or digits"));
}

BOOST_AUTO_TEST_SUITE_END()
