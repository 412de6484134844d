// Expressions in [elements]: what they stand for, what they measure, and what is wrong with the
// wrong ones.
#include <boost/test/unit_test.hpp>
#include <string>

#include "critical/certified.hpp"
#include "problem/problem.hpp"
#include "problem/variation.hpp"
#include "scene/scene.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"

BOOST_AUTO_TEST_SUITE(test_expressions)

using namespace vcrit;
using test::has;

namespace {

/// A contact over three springs at most; line 11 is the first of `elements`.
std::string text(const std::string& normal, const std::string& elements) {
  return "[contact]\nnormal = \"" + normal +
         "\"\ntangential = \"kt\"\n[oscillation]\nangular_frequency = 1e5\namplitude = 1e-7\n"
         "indentation = 5e-7\n[friction]\ncoefficient = 0.5\n[elements]\n" +
         elements;
}

Problem problem(const std::string& normal, const std::string& elements,
                const Settings& settings = {}) {
  return parse_problem(text(normal, elements), "s.toml", settings);
}

std::string message(const std::string& normal, const std::string& elements,
                    const Settings& settings = {}) {
  return test::refusal([&] { problem(normal, elements, settings).values(); });
}

/// Of the normal network's only element.
std::string amount(const std::string& elements) {
  const Problem made = problem("k1", elements);
  return to_text(std::get<Element>(made->normal.network().form).coefficient);
}

double velocity(const Problem& scene) { return certified_critical_velocity(scene).value; }

const std::string zener = "k0 | (k1 - c1)", flat = "shape = \"flat\"\nradius = 1e-3\n";
const std::string of_two = "k0 = 8e6\nk1 = \"k0/2\"\nc1 = \"tau*k1\"\ntau = \"8 us\"\nkt = 3e6\n";

}  // namespace

BOOST_AUTO_TEST_CASE(they_are_put_into_one_another) {
  BOOST_TEST(amount("k1 = \"2*k0\"\n") == "2*k0");
  BOOST_TEST(amount("k1 = \"2*(k0 + k2)/r\"\nk2 = \"0.5*k0\"\n") == "2*(k0 + 0.5*k0)/r");
  BOOST_TEST(amount("k1 = \"k2\"\nk2 = \"3*k0\"\n") == "3*k0");
  BOOST_TEST(amount("k1 = \"3*k2\"\nk2 = \"E\"\n") == "3*E");
  BOOST_TEST(amount("k1 = \"k0*r^2\"\n") == "k0*r*r");
  BOOST_TEST(amount("k1 = \"k0*r^-2\"\n") == "k0*(1/(r*r))");
  BOOST_TEST(amount("k1 = \"k[2]*1.5e-1\"\nk = [1, 2]\n") == "k[2]*1.5e-1");
  BOOST_TEST(amount("k1 = \"kt + kt\"\n") == "kt + kt");
}

// What was an alias, a number or a quantity stays one.
BOOST_AUTO_TEST_CASE(other_texts_are_no_expressions) {
  BOOST_TEST(amount("k1 = \"E\"\n") == "E");
  BOOST_TEST(amount("k1 = \"8 N/um\"\n") == "k1");
  BOOST_TEST(amount("k1 = \"8e6\"\n") == "k1");
}

// 0.3 N/m is no double, and neither is 0.3 times 1e6 rounded: v* is that of the exact product.
BOOST_AUTO_TEST_CASE(the_numbers_are_those_of_the_scene_written_out) {
  const std::string plain = "k0 = 8e6\nk1 = 4e6\nc1 = \"32 N.s/m\"\nkt = 3e6\n";
  BOOST_TEST(velocity(problem(zener, of_two)) == velocity(problem(zener, plain)));
  const double other = velocity(problem(zener, "k0 = 6e6\nk1 = 3e6\nc1 = 6\nkt = 3e6\n"));
  BOOST_TEST(velocity(problem(zener, of_two, {{"k0", "6 N/um"}, {"tau", "2 us"}})) == other);
  // 3e6 times 2^-19 is a double.
  const Problem changed = problem(zener, of_two).with({{{"k0"}, 6e6}, {{"tau"}, 0x1p-19}});
  BOOST_TEST(velocity(changed) ==
             velocity(problem(zener, "k0 = 6e6\nk1 = 3e6\nc1 = 5.7220458984375\nkt = 3e6\n")));
  const Problem typed = problem("k1", "k1 = \"0.3*k0\"\nk0 = \"1 N/um\"\nkt = 1\n");
  BOOST_TEST(velocity(typed) == velocity(problem("k1", "k1 = \"0.3 N/um\"\nkt = 1\n")));
}

BOOST_AUTO_TEST_CASE(parameters_are_numbers_of_the_scene) {
  const Problem made = problem(zener, of_two);
  BOOST_TEST((made.values().contains({"tau"})));
  BOOST_TEST((!made.values().contains({"k1"})));
  BOOST_CHECK(made->source->settable.at("tau") == Dimension::time);
  BOOST_TEST(!made->source->settable.contains("k1"));
  BOOST_TEST(made->source->warnings.empty());
  BOOST_TEST(has(message(zener, "k1 = \"k0*r\"\n"), "no value for k0, r, c1, kt"));
}

BOOST_AUTO_TEST_CASE(parameters_measure_what_fits) {
  const auto dimension = [](const std::string& elements) {
    return problem("k1 | c1", elements)->source->settable.at("x");
  };
  BOOST_CHECK(dimension("c1 = \"k1*x\"\n") == Dimension::time);
  BOOST_CHECK(dimension("c1 = \"k1*x\"\nx = 0.002\n") == Dimension::time);
  BOOST_CHECK(dimension("k1 = \"c1/x\"\n") == Dimension::time);
  BOOST_CHECK(dimension("k1 = \"x*kt\"\n") == Dimension::none);
  BOOST_CHECK(dimension("k1 = \"kt*(1 + x)\"\n") == Dimension::none);
  BOOST_CHECK(dimension("k1 = \"kt + x\"\n") == Dimension::stiffness);
  BOOST_CHECK(dimension("c1 = \"x/2\"\n") == Dimension::damping);
  BOOST_CHECK(dimension("k1 = \"x*y/y\"\ny = \"2 s\"\n") == Dimension::stiffness);
  // What the expressions leave open goes by its first letter, as in networks.
  BOOST_CHECK(dimension("k1 = \"2*(k5 + k6)/x\"\n") == Dimension::none);
  BOOST_CHECK(dimension("k1 = \"c5/x\"\n") == Dimension::time);
  BOOST_CHECK(dimension("k1 = \"kt*x*y\"\n") == Dimension::none);
  BOOST_CHECK(dimension("k1 = \"kt*x/x\"\n") == Dimension::none);
  // By way of another parameter.
  BOOST_CHECK(dimension("k1 = \"kt*y\"\nc1 = \"kt*y*x\"\n") == Dimension::time);
  const Problem modulus = test::scene_of(
      {.normal = "kelvin(E0, c0)", .indenter = flat, .elements = {{"c0", "E0*x"}, {"E0", "y*2"}}});
  BOOST_CHECK(modulus->source->settable.at("x") == Dimension::time);
  BOOST_CHECK(modulus->source->settable.at("y") == Dimension::modulus);
}

// Below an indenter elements of the drive are in N/m and N s/m, those of the half-space in Pa and
// Pa s; each expression has the unit of its own element.
BOOST_AUTO_TEST_CASE(on_a_drive_an_indenter_has_both_kinds_of_units) {
  const auto made = [](const std::string& elements) {
    return Problem(test::scene_of(test::symbolic({.normal = "kelvin(E0, c0)",
                                                  .indenter = flat,
                                                  .network = "kd | cd",
                                                  .more = "[elements]\n" + elements})));
  };
  const auto dimension = [&](const std::string& elements) {
    return made(elements)->source->settable.at("x");
  };
  BOOST_CHECK(dimension("kd = \"2*x\"\n") == Dimension::stiffness);
  BOOST_CHECK(dimension("kd = \"2*x\"\nx = \"3 N/mm\"\n") == Dimension::stiffness);
  BOOST_CHECK(dimension("E0 = \"2*x\"\nx = \"3 GPa\"\n") == Dimension::modulus);
  BOOST_CHECK(dimension("E0 = \"2*x\"\n") == Dimension::modulus);
  BOOST_CHECK(dimension("cd = \"x/3\"\n") == Dimension::damping);
  BOOST_CHECK(dimension("c0 = \"x/3\"\n") == Dimension::viscosity);
  BOOST_CHECK(dimension("cd = \"kd*x\"\nc0 = \"E0*x\"\n") == Dimension::time);
  // Moduli cancel.
  BOOST_CHECK(dimension("kd = \"x*c0/(E0*t)\"\nt = \"1 s\"\n") == Dimension::stiffness);
  // By its letter, of the part in which the expression is.
  const auto first = [&](const std::string& elements) { return made(elements)->source->settable; };
  BOOST_CHECK(first("kd = \"k5*r\"\n").at("k5") == Dimension::stiffness);
  BOOST_CHECK(first("E0 = \"k5*r\"\n").at("k5") == Dimension::modulus);
  const std::string moved =
      "[oscillation]\nangular_frequency = 1\namplitude = 1e-7\nindentation = 5e-7\n[friction]\n"
      "coefficient = 0.3\n";
  const Values values =
      made("kd = \"2*k0\"\nk0 = \"3 N/mm\"\ncd = 1\nE0 = 1\nc0 = 1\n" + moved).values();
  BOOST_TEST(values.at({"k0"}) == 3000);

  const auto refused = [&](const std::string& elements) {
    return test::refusal([&] { made(elements); });
  };
  BOOST_TEST(has(refused("kd = \"2*E0\"\n"),
                 "s.toml:10:6: found kd = \"2*E0\", a modulus in Pa; expected a stiffness in N/m"));
  BOOST_TEST(has(refused("kd = \"2*E0\"\n"), "elements of the half-space are per length"));
  BOOST_TEST(has(refused("c0 = \"2*cd\"\n"), "expected a viscosity in Pa.s"));
  BOOST_TEST(has(refused("kd = \"2*x\"\nx = \"3 GPa\"\n"), "expected a stiffness in N/m"));
  BOOST_TEST(has(refused("E0 = \"2*x\"\nx = \"3 N/mm\"\n"), "expected a modulus in Pa"));
  BOOST_TEST(has(refused("kd = \"2*x\"\nx = \"3 km\"\n"), "a modulus in Pa"));
  BOOST_TEST(has(refused("kd = \"E0\"\n"), "they need names of their own"));
  BOOST_TEST(has(refused("kd = \"kd*kd\"\n"), "circle"));
}

// Nor may one name be an element of both.
BOOST_AUTO_TEST_CASE(half_space_and_drive_share_no_element) {
  BOOST_TEST(
      has(test::refusal([] { test::scene_of({.normal = "k", .indenter = flat, .network = "k"}); }),
          "found \"k\" as a stiffness in N/m; expected a modulus in Pa, as at s.toml:2:"));
}

BOOST_AUTO_TEST_CASE(what_does_not_fit_is_refused) {
  BOOST_TEST(has(message("k1", "k1 = \"2*k0 + 3\"\nk0 = \"1 N/m\"\n"),
                 "s.toml:11:6: found k1 = \"2*k0 + 3\", which adds a stiffness in N/m and a plain "
                 "number; expected terms of one unit"));
  BOOST_TEST(has(message("k1", "k1 = \"kt*tau\"\ntau = \"2 ms\"\n"),
                 "s.toml:11:6: found k1 = \"kt*tau\", a damping coefficient in N.s/m; expected a "
                 "stiffness in N/m"));
  BOOST_TEST(has(message("k1", "k1 = \"kt*kt\"\n"), "something in kg^2 s^-4"));
  BOOST_TEST(
      has(message("k1", "k1 = \"kt*x\"\nx = \"2 km\"\n"), "s.toml:12:5: found x = \"2 km\""));
  BOOST_TEST(has(message("k1", "k1 = \"kt*x\"\nx = \"2 ms\"\n"), "expected a stiffness in N/m"));
  BOOST_TEST(has(message("k1", "k1 = \"x/y^2\"\nx = \"2 g\"\ny = \"1 ms\"\n"),
                 "of the mass x; expected masses in expressions of masses alone"));
  // A power of an unknown that nothing has.
  BOOST_TEST(has(message("k1", "k1 = \"kt*x^2*tau\"\ntau = \"1 s\"\n"), "expected a stiffness"));
}

BOOST_AUTO_TEST_CASE(circles_are_named) {
  BOOST_TEST(has(message("k1", "k1 = \"2*k2\"\nk2 = \"k3 + kt\"\nk3 = \"k1/2\"\n"),
                 "s.toml:11:6: found expressions in a circle: k1 (line 11) -> k2 (line 12) -> k3 "
                 "(line 13) -> k1 (line 11); expected a value for one of them"));
  BOOST_TEST(has(message("k1", "k1 = \"2*k1\"\n"), "in a circle: k1 (line 11) -> k1 (line 11)"));
  BOOST_TEST(has(message("k1", "k1 = \"k2\"\nk2 = \"2*k1\"\n"), "in a circle: k2"));
}

BOOST_AUTO_TEST_CASE(mistakes_are_named_with_their_place) {
  const auto of = [](const std::string& expression) {
    return message("k1", "k1 = \"" + expression + "\"\n");
  };
  BOOST_TEST(has(of("kt - k2"), "s.toml:11:10: found a difference in \"kt - k2\""));
  BOOST_TEST(has(of("2*"), "s.toml:11:9: found the end in \"2*\""));
  BOOST_TEST(has(of("(kt*2"), "s.toml:11:7: found \"(\" without \")\""));
  BOOST_TEST(has(of("kt)"), "found \")\""));
  BOOST_TEST(has(of("kt N/m"), "s.toml:11:10: found \"N\""));
  BOOST_TEST(has(of("0*kt"), "found number 0; expected a number above 0"));
  BOOST_TEST(has(of("1e400*kt"), "found number 1e400"));
  BOOST_TEST(has(of("kt^0.5"), "expected a whole power from 1 to 9"));
  BOOST_TEST(has(of("kt^r"), "expected a whole power from 1 to 9"));
  BOOST_TEST(has(of("kt^99"), "expected a whole power from 1 to 9"));
  BOOST_TEST(has(of("kt*class"), "name \"class\", which is a reserved word"));
  BOOST_TEST(has(of("kt*sqrt(r)"), "found \"(\""));
  BOOST_TEST(has(of("kt[1]*2"), "\"kt[1]\" in an expression; expected \"kt\", which is no array"));
  BOOST_TEST(has(message("k1", "k1 = \"2*k\"\nk = [1, 2]\n"), "\"k\" in an expression"));
  BOOST_TEST(has(message("k1", "k1 = \"2*k[3]\"\nk = [1, 2]\n"),
                 "expected an entry of that array, "
                 "k[1] to k[2]"));
  BOOST_TEST(has(message("k1", "k1 = \"kt*mass\"\n"), "\"mass\" as an element"));
  BOOST_TEST(has(message("k1", "k1 = \"kt*mu0\"\n"), "\"mu0\" as an element"));
  BOOST_TEST(has(of(std::string(300, '(') + "kt" + std::string(300, ')')), "too many brackets"));
  std::string many = "kt";
  for (int i = 0; i < 1001; ++i) many += "+kt";
  BOOST_TEST(has(of(many), "1000"));
}

// k40 would be a sum of 2^40 terms.
BOOST_AUTO_TEST_CASE(what_doubles_is_bounded) {
  std::string elements;
  for (int i = 40; i > 1; --i)
    elements += "k" + std::to_string(i) + " = \"k" + std::to_string(i - 1) + "+k" +
                std::to_string(i - 1) + "\"\n";
  BOOST_TEST(has(message("k40", elements), "of too many operations"));
  // A thousand entries of a thousand operations each, and one of a thousand in 5000 places.
  std::string large = "k0";
  for (int i = 1; i < 900; ++i) large += "+k0";
  std::string entries = "\"k1\"";
  for (int i = 1; i < 1200; ++i) entries += ", \"2*k1\"";
  BOOST_TEST(
      has(message("prony(k0, k, tau, 1200)", "k1 = \"" + large + "\"\nk = [" + entries + "]\n"),
          "expressions of more than 1000000 operations"));
  std::string springs = "k1";
  for (int i = 1; i < 5000; ++i) springs += "|k1";
  BOOST_TEST(has(message(springs, "k1 = \"" + large + "\"\n"),
                 "expressions of more than 4000000 operations, each use counted"));
}

BOOST_AUTO_TEST_CASE(zeros_are_left_out_of_sums_and_divide_nothing) {
  BOOST_TEST(amount("k1 = \"kt + k0\"\nk0 = 0\n") == "kt");
  BOOST_TEST(has(message("k1", "k1 = \"k0*2\"\nk0 = 0\n"), "elements of value 0 cut in two"));
  BOOST_CHECK(problem("k1 | c1", "k1 = 3\nc1 = \"k1*tau\"\ntau = 0\n")->normal.network() ==
              spring({"k1"}));
  BOOST_TEST(has(message("k1", "k1 = \"kt/r\"\nr = 0\n"),
                 "s.toml:11:6: found k1 = \"kt/r\", a division by 0; expected divisors above 0"));
  BOOST_TEST(has(message("k1", "k1 = \"kt/r\"\n", {{"r", "0"}}), "a division by 0"));
}

BOOST_AUTO_TEST_CASE(a_value_that_no_double_has_is_refused) {
  BOOST_TEST(has(message("k1", "k1 = \"kt*r^9\"\nkt = 1e300\nr = 1e10\n"),
                 "found k1 = kt*r*r*r*r*r*r*r*r*r = inf; expected a finite value above 0"));
  BOOST_CHECK_THROW(problem("k1", "k1 = \"kt*r\"\nkt = 1e300\nr = 1\n").with({{{"r"}, 1e10}}),
                    InputError);
}

// An expression is no number that one may set.
BOOST_AUTO_TEST_CASE(settings_and_axes_name_what_it_is_made_of) {
  const std::string words =
      "found k1, which is \"k0/2\" in this scene; expected a number that it is made of, or a value "
      "in its place in [elements]";
  BOOST_TEST(has(message(zener, of_two, {{"k1", "5"}}), words));
  BOOST_TEST(has(test::refusal([] { Variation(problem(zener, of_two), {"k1"}); }), words));
  const std::string aliased = "k0 = 8e6\nkx = \"k1\"\nk1 = \"k0/2\"\nkt = 1\n";
  BOOST_TEST(has(message("k0 | kx", aliased, {{"kx", "5"}}), words));
  const Problem moved = Variation(problem(zener, of_two), {"tau"}).at(std::vector{2e-6});
  BOOST_TEST(velocity(moved) == velocity(problem(zener, of_two, {{"tau", "2e-6"}})));
}

BOOST_AUTO_TEST_CASE(entries_of_arrays_may_be_expressions) {
  const std::string arrays =
      "k0 = 1e6\nk = [\"2*k0\", \"k[1]/4\", 5e5]\ntau = [\"1 us\", "
      "\"3*tau[1]\", \"1 ms\"]\nkt = 1e6\n";
  BOOST_TEST(
      velocity(problem("prony(k0, k, tau)", arrays)) ==
      velocity(problem("prony(k0, k, tau)",
                       "k0 = 1e6\nk = [2e6, 5e5, 5e5]\ntau = [\"1 us\", \"3 us\", \"1 ms\"]\n"
                       "kt = 1e6\n")));
}

BOOST_AUTO_TEST_CASE(odd_names_are_told_apart) {
  const Problem made = problem("spring(beta)", "beta = \"2*S*N/I\"\nS = \"1 N/m\"\n");
  BOOST_TEST(to_text(std::get<Element>(made->normal.network().form).coefficient) == "2*S*N/I");
  // Without a body a mass may be called m, and an expression has no symbol of its own.
  const Problem of_m = test::scene_of(
      {.normal = "k0", .network = "k1 | k2 - mass(m)", .elements = {{"m", "2*pi"}, {"pi", "1 g"}}});
  BOOST_CHECK(of_m->source->settable.at("pi") == Dimension::mass);
}

BOOST_AUTO_TEST_SUITE_END()
