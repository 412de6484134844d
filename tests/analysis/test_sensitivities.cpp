// Sensitivities against differences of v*, and the sums that scaling all parameters demands.
#include <boost/test/unit_test.hpp>

#include "analysis/abbreviations.hpp"
#include "analysis/sensitivities.hpp"
#include "derivation/derivation.hpp"
#include "derivation/scenes.hpp"
#include "derivation/values.hpp"
#include "formula/text.hpp"
#include "formula/value.hpp"
#include "support/random_scene.hpp"

BOOST_AUTO_TEST_SUITE(test_sensitivities)

using namespace vcrit;
using namespace vcrit::symbolic;
using test::scene_of;

namespace {

/// Sensitivities are of another derivation, which is gone: they stand for themselves.
struct Derived {
  explicit Derived(const Scene& scene) : full(derive(scene)), all(sensitivities(derive(scene))) {}

  Derivation full;
  Sensitivities all;
};

/// Shared lines name the definitions of v* besides.
std::vector<Line> definitions(const Derivation& full, const Sensitivities& every,
                              const Sensitivity& sensitivity) {
  std::vector<Line> all;
  if (!every.shared.empty()) all = full.definitions;
  all.insert(all.end(), every.shared.begin(), every.shared.end());
  all.insert(all.end(), sensitivity.stiffnesses.begin(), sensitivity.stiffnesses.end());
  all.insert(all.end(), sensitivity.changes.begin(), sensitivity.changes.end());
  return all;
}

GiNaC::numeric relative(const Derivation& full, const Sensitivities& every,
                        const Sensitivity& sensitivity, const test::ExactValues& values) {
  return value_at(sensitivity.relative, definitions(full, every, sensitivity), values);
}

/// p (v(p + h) - v(p - h))/(2 h v(p)) with h = 1e-60 p, of v(p) = `present`.
GiNaC::numeric difference(const Derivation& full, const Symbol& parameter,
                          const test::ExactValues& values, const GiNaC::numeric& present) {
  const GiNaC::numeric h("1/1000000000000000000000000000000000000000000000000000000000000");
  const auto velocity = [&](const GiNaC::numeric& factor) {
    test::ExactValues moved = values;
    moved.at(parameter) *= factor;
    return value_at(full.critical_velocity, full.definitions, moved);
  };
  return (velocity(1 + h) - velocity(1 - h)) / (2 * h * present);
}

// At 300 digits. The central difference errs by h^2/6 times the third derivative, 1e-120 times a
// ratio of values, and by the rounding of v* over h: less than 1e-200. Values within a decade and
// at most 20 elements leave twenty orders of magnitude to both.
const char* const tolerance = "1e-100";

void check(const Derived& derived, const test::ExactValues& values) {
  const auto& [full, all] = derived;
  const GiNaC::numeric velocity = value_at(full.critical_velocity, full.definitions, values);
  BOOST_REQUIRE(all.each.size() == full.parameters.size());
  for (const Sensitivity& sensitivity : all.each) {
    const GiNaC::numeric found = relative(full, all, sensitivity, values);
    const GiNaC::numeric expected = difference(full, sensitivity.parameter, values, velocity);
    BOOST_TEST((GiNaC::abs(found - expected) <= GiNaC::numeric(tolerance)),
               to_text(sensitivity.parameter));
    std::vector<Line> names = full.definitions;
    for (const Line& line : definitions(full, all, sensitivity)) names.push_back(line);
    const GiNaC::numeric slope = value_at(sensitivity.derivative, names, values);
    const GiNaC::numeric product = slope * values.at(sensitivity.parameter) / velocity;
    BOOST_TEST((GiNaC::abs(product - found) <= GiNaC::numeric(tolerance)));
  }
}

/// How often a unit of force, and of time, is in each parameter of a random scene.
struct Units {
  int force = 0, time = 0;
};

Units units(const Symbol& parameter) {
  if (parameter.name == "m") return {1, 2};
  if (parameter.name == "omega") return {0, -1};
  if (parameter.name.starts_with("k")) return {1, 0};
  if (parameter.name.starts_with("c")) return {1, 1};
  if (parameter.name.starts_with("tau")) return {0, 1};
  return {};
}

// Euler: v* does not change when all stiffnesses, dampers and masses are scaled together, and goes
// with 1/T when the unit of time is scaled by T.
void check_sums(const Derived& derived, const test::ExactValues& values) {
  GiNaC::numeric force = 0, time = 0;
  const auto& [full, all] = derived;
  for (const Sensitivity& sensitivity : all.each) {
    const GiNaC::numeric s = relative(full, all, sensitivity, values);
    force += s * units(sensitivity.parameter).force;
    time += s * units(sensitivity.parameter).time;
  }
  BOOST_TEST((GiNaC::abs(force) <= GiNaC::numeric(tolerance)));
  BOOST_TEST((GiNaC::abs(time + 1) <= GiNaC::numeric(tolerance)));
}

/// In g and Z the sensitivities are the same numbers.
void check_names(const Derived& derived, const test::ExactValues& values) {
  const auto& [full, plain] = derived;
  const Abbreviations names = abbreviations(full);
  const Sensitivities named = sensitivities(full, names);
  BOOST_REQUIRE(plain.each.size() == named.each.size());
  for (std::size_t i = 0; i < plain.each.size(); ++i) {
    std::vector<Line> lines = definitions(full, named, named.each[i]);
    for (const auto& name : {names.ratio, names.stiffness})
      if (name) lines.insert(lines.begin(), *name);
    const GiNaC::numeric expected = relative(full, plain, plain.each[i], values);
    const GiNaC::numeric found = value_at(named.each[i].relative, lines, values);
    BOOST_TEST((GiNaC::abs(found - expected) <= GiNaC::numeric(tolerance)),
               to_text(plain.each[i].parameter));
  }
}

const Sensitivity& of(const Sensitivities& all, const std::string& name) {
  for (const Sensitivity& sensitivity : all.each)
    if (to_text(sensitivity.parameter) == name) return sensitivity;
  throw std::runtime_error("no sensitivity to " + name);
}

/// The relative sensitivities at these values, by name.
std::map<std::string, GiNaC::numeric> all_of(const Scene& scene, const test::ExactValues& values) {
  const Derivation full = derive(scene);
  const Sensitivities every = sensitivities(full);
  std::map<std::string, GiNaC::numeric> found;
  for (const Sensitivity& each : every.each)
    found[to_text(each.parameter)] = relative(full, every, each, values);
  return found;
}

}  // namespace

// By hand: ln v* = ln(mu0 omega du_z kn/kt) + ln|kt + D| - ln|D| with D = kd - m omega^2.
BOOST_AUTO_TEST_CASE(an_elastic_contact_under_an_elastic_drive) {
  const auto all =
      sensitivities(derive(scene_of("normal = \"kn\"\ntangential = \"kt\"", "kd", "m")));
  const std::string both = "((kd + kt - m*omega^2)*(kd - m*omega^2))";
  BOOST_TEST(to_text(of(all, "mu0").relative) == "1");
  BOOST_TEST(to_text(of(all, "du_z").relative) == "1");
  BOOST_TEST(to_text(of(all, "kn").relative) == "1");
  BOOST_TEST(to_text(of(all, "m").relative) == "kt*m*omega^2/" + both);
  BOOST_TEST(to_text(of(all, "kd").relative) == "-kd*kt/" + both);
  BOOST_TEST(to_text(of(all, "kt").relative) == "-(kd - m*omega^2)/(kd + kt - m*omega^2)");
  BOOST_TEST(to_text(of(all, "kn").derivative) ==
             "mu0*omega*du_z*abs(kd + kt - m*omega^2)/(kt*abs(kd - m*omega^2))");
}

// v* = mu0 omega du_z (2 - nu)/(2(1 - nu)): S = -nu/(2 - nu) + nu/(1 - nu).
BOOST_AUTO_TEST_CASE(poissons_ratio) {
  const auto all = sensitivities(derive(scene_of("normal = \"k0 | (k1 - c1)\"\npoisson = \"nu\"")));
  BOOST_TEST(all.each.size() == 4u);
  BOOST_TEST(to_text(of(all, "nu").relative) == "nu/((1 - nu)*(2 - nu))");
}

BOOST_AUTO_TEST_CASE(sensitivities_are_what_differences_tend_to) {
  GiNaC::Digits = 300;
  for (const Scene& scene :
       {test::kelvin_scene(), scene_of("normal = \"k0 | (k1 - c1)\"\npoisson = 0.3", "kd", "m"),
        scene_of("normal = \"k0 | (k1 - c1)\"\npoisson = \"nu\"", "kd | cd", "m"),
        scene_of("normal = \"burgers(k1, c1, k2, c2)\"\ntangential_ratio = \"r\"", "kd"),
        scene_of("normal = \"prony(k0, k, tau, 12)\"\ntangential = \"kt | ct\"", "kd", "m"),
        scene_of("normal = \"prony(k0, k, tau, 12)\"\npoisson = \"nu\"", "kd", "m"),
        scene_of("normal = \"bridge\"\ntangential = \"kt | ct\"", "kd", "m", test::bridge_network),
        scene_of("normal = \"kn | cs\"\ntangential = \"kt - cs\"", "cs | kd", "m")}) {
    const Derived derived(scene);
    check(derived, test::some_values(scene));
    check_sums(derived, test::some_values(scene));
    check_names(derived, test::some_values(scene));
  }
}

BOOST_AUTO_TEST_CASE(random_scenes) {
  GiNaC::Digits = 300;
  constexpr unsigned seed = 20240614;
  BOOST_TEST_MESSAGE("seed " << seed);
  test::RandomScenes random(seed, 0.5);
  int nested = 0, graphs = 0;
  for (int i = 0; i < 60; ++i) {
    Scene scene = random.scene(i % 10 + 1);
    test::round_ratio(scene);
    const Derived derived(scene);
    nested += derived.full.definitions.empty() ? 0 : 1;
    graphs += std::holds_alternative<Graph>(scene.normal.form) ? 1 : 0;
    BOOST_TEST_CONTEXT("scene " << i) {
      check(derived, test::exact_values(scene));
      check_sums(derived, test::exact_values(scene));
      check_names(derived, test::exact_values(scene));
    }
  }
  BOOST_TEST(nested > 5);
  BOOST_TEST(nested < 55);
  BOOST_TEST(graphs > 3);
}

// Both ways to a sensitivity, by differentiating the formula and by the chain rule, give one value
// in one scene, where some are too long for a fraction.
BOOST_AUTO_TEST_CASE(a_formula_that_is_multiplied_out_may_have_sensitivities_that_are_not) {
  const Scene scene =
      scene_of("normal = \"k0 | (k1 - c1)\"\ntangential = \"k2 | (k3 - c3)\"", "kd | cd", "m");
  const auto all = sensitivities(derive(scene));
  const auto chained = [](const Sensitivity& s) { return !s.changes.empty(); };
  BOOST_TEST(derive(scene).definitions.empty());
  BOOST_TEST(std::any_of(all.each.begin(), all.each.end(), chained));
  BOOST_TEST(!std::all_of(all.each.begin(), all.each.end(), chained));
}

namespace {

Scene ladder(int rungs) {
  std::string network = "k0";
  for (int i = 1; i <= rungs; ++i)
    network = "(c" + std::to_string(i) + " | (k" + std::to_string(i) + " - " + network + "))";
  return scene_of("normal = \"" + network + "\"\ntangential = \"kt\"", "kd", "m");
}

struct Lines {
  std::size_t count = 0, longest = 0;

  void add(const std::vector<Line>& lines) {
    count += lines.size();
    for (const Line& line : lines) longest = std::max(longest, to_text(line.right).size());
  }
};

}  // namespace

// A ladder of n rungs is a chain of n names; no line grows with n.
BOOST_AUTO_TEST_CASE(the_chain_rule_does_not_swell) {
  const auto longest = [](const Derived& derived) {
    Lines lines;
    for (const Sensitivity& sensitivity : derived.all.each) lines.add(sensitivity.changes);
    BOOST_TEST(lines.count > 0u);
    return lines.longest;
  };
  const Scene large = ladder(30);
  const Derived derived(large);
  BOOST_TEST(longest(derived) < 2 * longest(Derived(ladder(10))));
  GiNaC::Digits = 300;
  check_sums(derived, test::some_values(large));
}

// Backwards, in as many lines for all parameters as v* has, where they would be as many for each.
BOOST_AUTO_TEST_CASE(many_parameters_share_their_lines) {
  GiNaC::Digits = 300;
  const Scene large = ladder(60);
  const Derived derived(large);
  const auto& [full, all] = derived;
  Lines shared, own;
  shared.add(all.shared);
  for (const Sensitivity& sensitivity : all.each) {
    own.add(sensitivity.stiffnesses);
    own.add(sensitivity.changes);
  }
  BOOST_TEST(own.count == 0u);
  BOOST_TEST(shared.count == full.definitions.size());
  // No line grows but by the digits of its names.
  Lines longer;
  longer.add(sensitivities(derive(ladder(90))).shared);
  BOOST_TEST(longer.longest < 1.2 * static_cast<double>(shared.longest));
  check(derived, test::some_values(large));
  check_sums(derived, test::some_values(large));
  check_names(derived, test::some_values(large));
}

BOOST_AUTO_TEST_CASE(masses_of_the_drive) {
  GiNaC::Digits = 300;
  const Scene scene = test::scene_of("normal = \"k0 | (k1 - c1)\"\ntangential = \"kt | ct\"",
                                     "k2 - (mass(m2) | k3 | c3)", "m");
  check(Derived(scene), test::some_values(scene));
}

// Loss factors bring i into the chain rule: i is no coefficient of FLINT's polynomials.
BOOST_AUTO_TEST_CASE(springs_with_loss_factors_in_formulas_that_stay_nested) {
  GiNaC::Digits = 300;
  for (const Scene& scene :
       {scene_of("normal = \"prony(k0, k, tau, 12) | lossy(kl, eta)\"\npoisson = \"nu\"", "kd"),
        scene_of("normal = \"prony(k0, k, tau, 12) - lossy(kl, eta)\"\ntangential = \"kt\"",
                 "kd | c1 - lossy(kl, eta)", "m")}) {
    const Derived derived(scene);
    BOOST_TEST(!derived.full.definitions.empty());
    check(derived, test::some_values(scene));
    check_names(derived, test::some_values(scene));
  }
}

// A measured R_d is a complex number that no parameter changes but omega, which is left out.
BOOST_AUTO_TEST_CASE(measured_drives) {
  GiNaC::Digits = 300;
  const Scene scene = read_scene(VCRIT_SCENES "/measured_drive.toml");
  const test::ExactValues values = test::some_values(scene);
  const Line receptance{"", quantity("R_d"),
                        GiNaC::numeric(3, 7) - GiNaC::I * GiNaC::numeric(2, 5)};
  Derivation full = derive(scene);
  full.definitions.insert(full.definitions.begin(), receptance);
  const Sensitivities all = sensitivities(derive(scene));
  BOOST_TEST(all.each.size() + 1 == full.parameters.size());
  const GiNaC::numeric velocity = value_at(full.critical_velocity, full.definitions, values);
  for (const Sensitivity& sensitivity : all.each) {
    BOOST_TEST((sensitivity.parameter != Symbol{"omega"}));
    std::vector<Line> names = definitions(full, all, sensitivity);
    names.insert(names.begin(), receptance);
    const GiNaC::numeric found = value_at(sensitivity.relative, names, values);
    const GiNaC::numeric expected = difference(full, sensitivity.parameter, values, velocity);
    BOOST_TEST((GiNaC::abs(found - expected) <= GiNaC::numeric(tolerance)),
               to_text(sensitivity.parameter));
  }
}

// ln k1 = ln k0 - ln 2 and ln c1 = ln k1 + ln tau: the chain rule is a sum.
BOOST_AUTO_TEST_CASE(what_is_made_of_others_changes_with_them) {
  GiNaC::Digits = 300;
  const std::string contact = "normal = \"k0 | (k1 - c1)\"\ntangential = \"kt | (k2 - c1)\"";
  const Scene made = scene_of(contact, "kd", "m",
                              "[elements]\nk1 = \"k0/2\"\nc1 = \"k1*tau\"\nk2 = \"k0 + 3*kt\"\n");
  const Scene plain = scene_of(contact, "kd", "m");
  test::ExactValues values = test::some_values(made);
  check(Derived(made), values);
  const auto chained = all_of(made, values);
  const GiNaC::numeric k0 = values.at({"k0"}), kt = values.at({"kt"});
  values[{"k1"}] = k0 / 2;
  values[{"c1"}] = k0 / 2 * values.at({"tau"});
  values[{"k2"}] = k0 + 3 * kt;
  auto alone = all_of(plain, values);
  const GiNaC::numeric share = k0 / (k0 + 3 * kt);
  const std::map<std::string, GiNaC::numeric> expected{
      {"k0", alone["k0"] + alone["k1"] + alone["c1"] + alone["k2"] * share},
      {"kt", alone["kt"] + alone["k2"] * (1 - share)},
      {"tau", alone["c1"]},
      {"kd", alone["kd"]},
      {"m", alone["m"]}};
  BOOST_TEST(chained.size() == expected.size() + 3);  // mu0, omega, du_z
  for (const auto& [name, value] : expected)
    BOOST_TEST((GiNaC::abs(chained.at(name) - value) <= GiNaC::numeric(tolerance)), name);
  // The formulas are one, but for roundings in an order that is not the same in every run.
  const auto velocity = [&](const Scene& scene) {
    const Derivation derivation = derive(scene);
    return value_at(derivation.critical_velocity, derivation.definitions, values);
  };
  BOOST_TEST((GiNaC::abs(velocity(made) / velocity(plain) - 1) <= GiNaC::numeric(tolerance)));
}

BOOST_AUTO_TEST_SUITE_END()
