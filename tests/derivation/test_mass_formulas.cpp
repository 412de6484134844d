// Formulas of drives with masses of their own, and the general law v* = mu0 omega |F_n| |H|.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "analysis/limits.hpp"
#include "derivation/derivation.hpp"
#include "derivation/model.hpp"
#include "derivation/scenes.hpp"
#include "formula/symbols.hpp"
#include "formula/text.hpp"
#include "formula/value.hpp"
#include "problem/problem.hpp"
#include "support/nodal.hpp"
#include "support/random_scene.hpp"

BOOST_AUTO_TEST_SUITE(test_mass_formulas)

using namespace vcrit;
using namespace vcrit::symbolic;

namespace {

constexpr unsigned seed = 20261121;

GiNaC::numeric number(const test::Real& value) { return GiNaC::numeric(value.str(120).c_str()); }

GiNaC::ex line(const Derivation& derivation, const std::string& words) {
  for (const Line& each : derivation.lines)
    if (each.words.text().find(words) != std::string::npos) return each.right;
  throw std::runtime_error("no line " + words);
}

std::string formula(const Scene& scene) { return to_text(derive(scene).critical_velocity); }

}  // namespace

BOOST_AUTO_TEST_CASE(random_drives_have_the_values_of_nodal_analysis) {
  BOOST_TEST_MESSAGE("seed " << seed);
  GiNaC::Digits = 150;
  test::RandomScenes random(seed, 2);
  int nested = 0;
  for (int i = 0; i < 60; ++i) {
    Scene scene = random.scene(2);
    if (auto* isotropic = std::get_if<Isotropic>(&scene.tangential))
      isotropic->quantity.value = 0.375;  // the same as a decimal and as a double
    scene.drive = random.drive_with_masses(1 + i % 3, scene);
    const Derivation derivation = derive(scene);
    nested += derivation.definitions.empty() ? 0 : 1;
    std::map<Symbol, GiNaC::numeric> values;
    for (const auto& [symbol, value] : resolve(scene).values())
      values[symbol] = exact_binary(value);
    const GiNaC::numeric derived =
        value_at(derivation.critical_velocity, derivation.definitions, values);
    const GiNaC::numeric nodal = number(test::critical_velocity_by_nodes(scene));
    // 24 terms over 4 decades each lose at most some 24*4/2 of the 150 digits carried, and as many
    // again where a resonance is that near; the nodal values carry 250.
    BOOST_TEST((GiNaC::abs(derived / nodal - 1) < GiNaC::numeric("1e-45")),
               "scene " << i << " of seed " << seed);
  }
  BOOST_TEST(nested > 10);
  BOOST_TEST(nested < 55);
}

BOOST_AUTO_TEST_CASE(a_body_is_a_mass_at_the_near_end_of_the_drive) {
  for (const std::string contact :
       {"normal = \"kn\"\ntangential = \"kt | ct\"", "normal = \"k0 | (k1 - c1)\"\npoisson = 0.3"})
    for (const std::string drive : {"kd", "kd | cd", "k3 - (mass(m3) | k4)"})
      BOOST_TEST(formula(test::scene_of(contact, drive, "m")) ==
                 formula(test::scene_of(contact, "mass(m) | (" + drive + ")")));
}

BOOST_AUTO_TEST_CASE(the_general_law_is_derived_and_eq_24_is_its_special_case) {
  const Derivation derivation = derive(test::kelvin_scene());
  const GiNaC::ex k_t = quantity("K_t"), k_d = quantity("K_d"), k_n = quantity("K_n");
  const GiNaC::ex inertia = symbol({"m"}) * GiNaC::pow(omega(), 2);
  const GiNaC::ex H = line(derivation, "Receptance");
  BOOST_TEST(H.is_equal(1 / k_t + 1 / (k_d - inertia)));
  const GiNaC::ex law = line(derivation, "For any linear structure");
  const GiNaC::ex friction = symbol({"mu0"}) * omega() * symbol({"du_z"});
  BOOST_TEST(law.is_equal(friction * GiNaC::abs(k_n) * GiNaC::abs(quantity("H"))));
  // |H| = |K_t + K_d - m omega^2|/(|K_t| |K_d - m omega^2|): the product under the absolute values.
  const GiNaC::ex eq24 = line(derivation, "For any networks (24)");
  const GiNaC::ex product = friction * k_n * (k_t + k_d - inertia) / (k_t * (k_d - inertia));
  BOOST_TEST((friction * k_n * H - product).normal().is_zero());
  BOOST_TEST(eq24.is_equal(friction * GiNaC::abs(k_n) * GiNaC::abs(k_t + k_d - inertia) /
                           (GiNaC::abs(k_t) * GiNaC::abs(k_d - inertia))));
}

BOOST_AUTO_TEST_CASE(limits_of_a_drive_with_masses_are_approached) {
  GiNaC::Digits = 200;
  const Scene scene = test::scene_of(test::kelvin_contact, "k1 - (mass(m1) | k2 | c2)", "m");
  std::map<Symbol, GiNaC::numeric> values{{{"mu0"}, GiNaC::numeric(3, 10)},
                                          {{"omega"}, GiNaC::numeric(7, 3)},
                                          {{"du_z"}, GiNaC::numeric(1, 7)},
                                          {{"m"}, GiNaC::numeric(11, 13)}};
  int count = 0;
  for (const auto& [symbol, value] : scene.elements)
    values[symbol] = GiNaC::numeric(17 + 5 * count++, 19);
  const Derivation full = derive(scene);
  int checked = 0;
  for (const Limit& limit : limits(derive(scene))) {
    if (limit.rates.empty()) continue;
    auto near = values;
    for (const auto& [symbol, rate] : limit.rates)
      near.at(symbol) *= GiNaC::pow(GiNaC::numeric(10), GiNaC::numeric(25 * rate));
    const GiNaC::numeric distance = value_at(full.critical_velocity, full.definitions, near) /
                                        value_at(limit.result, limit.definitions, values) -
                                    1;
    // Rational functions approach their limits at least like C/T, T = 1e25; C is a ratio of values.
    BOOST_TEST((GiNaC::abs(distance) < GiNaC::numeric("1e-15")), limit.name);
    ++checked;
  }
  // Drive, m; cn to 0; kt and ct, m1, k2 and c2 both ways, k1 to infinity alone; all dampers, and
  // then the drive.
  BOOST_TEST(checked == 16);
}

// A mass of the drive that vanishes is not there; one that grows without end holds its point.
BOOST_AUTO_TEST_CASE(limits_of_a_mass_of_the_drive) {
  const auto scene = [](const std::string& drive) {
    return test::scene_of(test::kelvin_contact, drive, "m");
  };
  const Scene chain = scene("k1 - (mass(m1) | k2 | c2)");
  const auto limit = [model = SymbolicModel(chain)](int rate) {
    Change change;
    change.rates[{"m1"}] = rate;
    return to_text(model.formula(change).value().velocity);
  };
  BOOST_TEST(limit(-1) == formula(scene("k1 - (k2 | c2)")));
  BOOST_TEST(limit(1) == formula(scene("k1")));
  // Beside the body a mass that grows holds the body: the drive becomes rigid.
  const SymbolicModel beside(scene("mass(m1) | k1"));
  Change change;
  change.rates[{"m1"}] = 1;
  BOOST_TEST(to_text(beside.formula(change).value().velocity) ==
             formula(test::scene_of(test::kelvin_contact)));
}

BOOST_AUTO_TEST_CASE(a_parameter_is_named_once) {
  const std::vector<Symbol> parameters =
      derive(test::scene_of("normal = \"kn\"\ntangential = \"kt\"", "mass(m) | kd")).parameters;
  BOOST_TEST((parameters ==
              std::vector<Symbol>{{"mu0"}, {"omega"}, {"du_z"}, {"kn"}, {"kt"}, {"m"}, {"kd"}}));
}

BOOST_AUTO_TEST_SUITE_END()
