// Sensitivities against differences of v*, and the sums that scaling all parameters demands.
#include <boost/test/unit_test.hpp>

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

std::vector<Line> definitions(const Sensitivity& sensitivity) {
  std::vector<Line> all = sensitivity.stiffnesses;
  all.insert(all.end(), sensitivity.changes.begin(), sensitivity.changes.end());
  return all;
}

GiNaC::numeric relative(const Sensitivity& sensitivity, const test::ExactValues& values) {
  return value_at(sensitivity.relative, definitions(sensitivity), values);
}

/// p (v(p + h) - v(p - h))/(2 h v(p)) with h = 1e-60 p.
GiNaC::numeric difference(const Derivation& full, const Symbol& parameter,
                          const test::ExactValues& values) {
  const GiNaC::numeric h("1/1000000000000000000000000000000000000000000000000000000000000");
  const auto velocity = [&](const GiNaC::numeric& factor) {
    test::ExactValues moved = values;
    moved.at(parameter) *= factor;
    return value_at(full.critical_velocity, full.definitions, moved);
  };
  return (velocity(1 + h) - velocity(1 - h)) / (2 * h * velocity(1));
}

// At 300 digits. The central difference errs by h^2/6 times the third derivative, 1e-120 times a
// ratio of values, and by the rounding of v* over h: less than 1e-200. Values within a decade and
// at most 20 elements leave twenty orders of magnitude to both.
const char* const tolerance = "1e-100";

void check(const Scene& scene, const test::ExactValues& values) {
  const Derivation full = derive(scene);
  const std::vector<Sensitivity> all = sensitivities(derive(scene));
  BOOST_REQUIRE(all.size() == full.parameters.size());
  for (const Sensitivity& sensitivity : all) {
    const GiNaC::numeric found = relative(sensitivity, values);
    const GiNaC::numeric expected = difference(full, sensitivity.parameter, values);
    BOOST_TEST((GiNaC::abs(found - expected) <= GiNaC::numeric(tolerance)),
               to_text(sensitivity.parameter));
    std::vector<Line> names = full.definitions;
    for (const Line& line : definitions(sensitivity)) names.push_back(line);
    const GiNaC::numeric slope = value_at(sensitivity.derivative, names, values);
    const GiNaC::numeric velocity = value_at(full.critical_velocity, full.definitions, values);
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
void check_sums(const Scene& scene, const test::ExactValues& values) {
  GiNaC::numeric force = 0, time = 0;
  for (const Sensitivity& sensitivity : sensitivities(derive(scene))) {
    const GiNaC::numeric s = relative(sensitivity, values);
    force += s * units(sensitivity.parameter).force;
    time += s * units(sensitivity.parameter).time;
  }
  BOOST_TEST((GiNaC::abs(force) <= GiNaC::numeric(tolerance)));
  BOOST_TEST((GiNaC::abs(time + 1) <= GiNaC::numeric(tolerance)));
}

const Sensitivity& of(const std::vector<Sensitivity>& all, const std::string& name) {
  for (const Sensitivity& sensitivity : all)
    if (to_text(sensitivity.parameter) == name) return sensitivity;
  throw std::runtime_error("no sensitivity to " + name);
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
  BOOST_TEST(all.size() == 4u);
  BOOST_TEST(to_text(of(all, "nu").relative) == "nu/((1 - nu)*(2 - nu))");
}

BOOST_AUTO_TEST_CASE(sensitivities_are_what_differences_tend_to) {
  GiNaC::Digits = 300;
  for (const Scene& scene :
       {test::kelvin_scene(),
        scene_of("normal = \"k0 | (k1 - c1)\"\npoisson = \"nu\"", "kd | cd", "m"),
        scene_of("normal = \"burgers(k1, c1, k2, c2)\"\ntangential_ratio = \"r\"", "kd"),
        scene_of("normal = \"prony(k0, k, tau, 12)\"\ntangential = \"kt | ct\"", "kd", "m"),
        scene_of("normal = \"prony(k0, k, tau, 12)\"\npoisson = \"nu\"", "kd", "m"),
        scene_of("normal = \"bridge\"\ntangential = \"kt | ct\"", "kd", "m", test::bridge_network),
        scene_of("normal = \"kn | cs\"\ntangential = \"kt - cs\"", "cs | kd", "m")}) {
    check(scene, test::some_values(scene));
    check_sums(scene, test::some_values(scene));
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
    nested += derive(scene).definitions.empty() ? 0 : 1;
    graphs += std::holds_alternative<Graph>(scene.normal.form) ? 1 : 0;
    BOOST_TEST_CONTEXT("scene " << i) {
      check(scene, test::exact_values(scene));
      check_sums(scene, test::exact_values(scene));
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
  BOOST_TEST(std::any_of(all.begin(), all.end(), chained));
  BOOST_TEST(!std::all_of(all.begin(), all.end(), chained));
}

// A ladder of n rungs is a chain of n names; no line grows with n.
BOOST_AUTO_TEST_CASE(the_chain_rule_does_not_swell) {
  const auto ladder = [](int rungs) {
    std::string network = "k0";
    for (int i = 1; i <= rungs; ++i)
      network = "(c" + std::to_string(i) + " | (k" + std::to_string(i) + " - " + network + "))";
    return scene_of("normal = \"" + network + "\"\ntangential = \"kt\"", "kd", "m");
  };
  const auto longest = [](const Scene& scene) {
    std::size_t most = 0;
    for (const Sensitivity& sensitivity : sensitivities(derive(scene)))
      for (const Line& line : sensitivity.changes)
        most = std::max(most, to_text(line.right).size());
    return most;
  };
  const Scene large = ladder(40);
  BOOST_TEST(longest(large) < 2 * longest(ladder(10)));
  GiNaC::Digits = 300;
  check_sums(large, test::some_values(large));
}

BOOST_AUTO_TEST_CASE(masses_of_the_drive) {
  GiNaC::Digits = 300;
  const Scene scene = test::scene_of("normal = \"k0 | (k1 - c1)\"\ntangential = \"kt | ct\"",
                                     "k2 - (mass(m2) | k3 | c3)", "m");
  check(scene, test::some_values(scene));
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
  const std::vector<Sensitivity> all = sensitivities(derive(scene));
  BOOST_TEST(all.size() + 1 == full.parameters.size());
  for (const Sensitivity& sensitivity : all) {
    BOOST_TEST((sensitivity.parameter != Symbol{"omega"}));
    std::vector<Line> names = definitions(sensitivity);
    names.insert(names.begin(), receptance);
    const GiNaC::numeric found = value_at(sensitivity.relative, names, values);
    const GiNaC::numeric expected = difference(full, sensitivity.parameter, values);
    BOOST_TEST((GiNaC::abs(found - expected) <= GiNaC::numeric(tolerance)),
               to_text(sensitivity.parameter));
  }
}

BOOST_AUTO_TEST_SUITE_END()
