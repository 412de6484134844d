// A scene's networks as materials: spectra and functions by hand, and the page about them.
#include "report/material_page.hpp"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <complex>

#include "report/material.hpp"
#include "scene/scene.hpp"
#include "support/patterns.hpp"
#include "support/scene_text.hpp"

BOOST_AUTO_TEST_SUITE(test_material_page)

using namespace vcrit;
using namespace vcrit::validation::report;

namespace {

Network normal_of(const std::string& network) {
  return test::scene_of(test::symbolic({.normal = network})).normal;
}

/// Without numbers but those of its elements.
std::string page_of_scene(const test::SceneText& text) {
  return material_page(test::scene_of(test::symbolic(text)));
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

/// A square of n by n nodes, of springs and dampers in turn, between its left and its right.
std::string grid(int n) {
  std::string edges;
  auto edge = [&edges, number = 0](const std::string& from, const std::string& to) mutable {
    const std::string name = (number % 2 == 0 ? "k" : "c") + std::to_string(number);
    edges += "[\"" + name + "\", \"" + from + "\", \"" + to + "\"], ";
    ++number;
  };
  const auto node = [](int i, int j) { return std::to_string(i) + "." + std::to_string(j); };
  for (int i = 0; i < n; ++i) {
    edge("a", node(i, 0));
    edge(node(i, n - 1), "b");
    for (int j = 0; j < n; ++j) {
      if (j + 1 < n) edge(node(i, j), node(i, j + 1));
      if (i + 1 < n) edge(node(i, j), node(i + 1, j));
    }
  }
  return "[networks.grid]\nterminals = [\"a\", \"b\"]\nedges = [" + edges + "]\n";
}

const test::SceneText zener{.normal = "zener(k0, k1, c1)"};

}  // namespace

// R = k0 + k1 exp(-t k1/c1); J = 1/k0 - (1/k0 - 1/(k0 + k1)) exp(-t/lambda), lambda = c1 (k0 +
// k1)/(k0 k1). Some ten roundings.
BOOST_AUTO_TEST_CASE(zener_by_hand) {
  const double k0 = 2, k1 = 3, c1 = 0.5;
  const MaterialNumbers numbers =
      material_numbers(normal_of("zener(k0, k1, c1)"), {{{"k0"}, k0}, {{"k1"}, k1}, {{"c1"}, c1}});
  const double lambda = c1 * (k0 + k1) / (k0 * k1);
  for (const double t : {1e-3, 0.1, 0.4, 3.0}) {
    const auto close = boost::test_tools::tolerance(1e-14);
    BOOST_TEST(numbers.relaxation_function(t) == k0 + k1 * std::exp(-t * k1 / c1), close);
    BOOST_TEST(
        numbers.creep_function(t) == 1 / k0 - (1 / k0 - 1 / (k0 + k1)) * std::exp(-t / lambda),
        close);
  }
}

// Burgers: J = 1/k1 + t/c1 + (1 - exp(-t k2/c2))/k2.
BOOST_AUTO_TEST_CASE(burgers_by_hand) {
  const MaterialNumbers numbers = material_numbers(
      normal_of("burgers(k1, c1, k2, c2)"), {{{"k1"}, 2}, {{"c1"}, 5}, {{"k2"}, 0.5}, {{"c2"}, 3}});
  for (const double t : {0.01, 1.0, 30.0})
    BOOST_TEST(numbers.creep_function(t) == 1 / 2.0 + t / 5 - std::expm1(-t * 0.5 / 3) / 0.5,
               boost::test_tools::tolerance(1e-13));
}

// Both spectra are one network: K times the compliance is 1 at every frequency.
BOOST_AUTO_TEST_CASE(both_spectra_are_of_one_network) {
  for (const char* text : {"k0 | (k1 - c1) | (k2 - c2)", "k0 - (k1 | c1) - (k2 | c2) - c3",
                           "k0 | c0 | (k1 - c1)", "k0", "c0", "k0 | (k1 - (c1 | (k2 - c2)))"}) {
    const Network network = normal_of(text);
    Values values;
    for (const Symbol& symbol : symbols_of(network))
      values[symbol] = 1 + static_cast<double>(values.size()) * 0.7;
    const MaterialNumbers numbers = material_numbers(network, values);
    for (const double omega : {0.03, 0.7, 20.0}) {
      const std::complex<double> s(0, omega);
      std::complex<double> compliance =
          numbers.retardation.glassy + numbers.retardation.fluidity / s;
      for (const KelvinUnit& unit : numbers.retardation.units)
        compliance += unit.compliance / (1.0 + unit.time * s);
      BOOST_TEST(std::abs(compliance * dynamic_stiffness(numbers.relaxation, omega) - 1.0) < 1e-12,
                 text << " at " << omega);
    }
  }
}

BOOST_AUTO_TEST_CASE(without_values_the_page_is_in_symbols) {
  const std::string page = page_of_scene(zener);
  for (const char* part : {"Storage, loss and loss factor", "<h3>Relaxation</h3>", "<h3>Creep</h3>",
                           "Glassy stiffness", "What the formula says", "Critical velocity"})
    BOOST_TEST(has(page, part), part);
  BOOST_TEST(!has(page, "<h3>In numbers</h3>"));
}

BOOST_AUTO_TEST_CASE(with_values_it_has_numbers_and_curves) {
  const std::string page =
      page_of_scene({.normal = zener.normal, .elements = {{"k0", 2}, {"k1", 3}, {"c1", 0.5}}});
  BOOST_TEST(has(page, "<h3>In numbers</h3>"));
  for (const char* figure : {"stiffness", "loss_factor", "relaxation", "creep"})
    BOOST_TEST(has(page, "<figure id=\"normal_" + std::string(figure) + "\">"), figure);
  BOOST_TEST(has(page, "<td>166.7 ms</td><td>3 N/m</td>"));  // c1/k1
  BOOST_TEST(!test::has_match(page, "\\bnan\\b"));           // but in "resonance"
}

// Masses, lossy springs and long series have no closed spectra; measured drives no network.
BOOST_AUTO_TEST_CASE(every_scene_has_a_page) {
  BOOST_TEST(has(page_of_scene({.normal = "lossy(k0, eta)"}), "no law of motion in time"));
  BOOST_TEST(has(page_of_scene({.normal = zener.normal, .network = "kd | mass(m1)"}),
                 "The network holds masses"));
  BOOST_TEST(has(page_of_scene({.normal = "prony(k0, k, tau, 30)"}),
                 "The retardation spectrum has no closed form"));
  BOOST_TEST(has(material_page(read_problem(VCRIT_SCENES "/measured_drive.toml")),
                 "The drive is measured"));
}

// Its stiffness at rest would have more terms than one reads, and take minutes.
BOOST_AUTO_TEST_CASE(a_grid_has_a_page_without_its_ends) {
  const std::string page = page_of_scene({.normal = "grid", .more = grid(12)});
  BOOST_TEST(has(page, "The relaxation spectrum has no closed form"));
  BOOST_TEST(!has(page, "Equilibrium stiffness"));
}

// Each of its limits is as long as v*: 13 MB before they were counted.
BOOST_AUTO_TEST_CASE(limits_of_a_grid_are_left_out_and_that_is_said) {
  const std::string page =
      page_of_scene({.normal = "grid", .network = "kd | cd", .mass = "m", .more = grid(6)});
  BOOST_TEST(page.size() < 10'000'000u);
  BOOST_TEST(has(page, "together they would have some"));
  BOOST_TEST(!has(page_of_scene(zener), "together they would have some"));
}

BOOST_AUTO_TEST_CASE(texts_of_the_scene_are_escaped) {
  const std::string page = material_page(parse_problem(
      "title = \"<script>alert(1)</script>\"\n" + to_toml(test::symbolic(zener)), "test.toml"));
  BOOST_TEST(!has(page, "<script>alert"));
}

BOOST_AUTO_TEST_SUITE_END()
