// Stability maps: digits lost are what conditioning says, lines lie where they should, and a wrong
// answer of the simulator is seen.
#include "accuracy/stability.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "accuracy/cells.hpp"
#include "accuracy/resonance.hpp"
#include "accuracy/simulated_cell.hpp"
#include "critical/admissibility.hpp"
#include "critical/certified.hpp"
#include "critical/conditioning.hpp"
#include "problem/problem.hpp"
#include "scene/scene.hpp"
#include "support/scene_text.hpp"

BOOST_AUTO_TEST_SUITE(test_accuracy_stability)

using namespace vcrit;
using namespace vcrit::validation;
using namespace vcrit::validation::accuracy;

namespace {

Scene scene_named(const std::string& name) {
  return read_scene(std::string(VCRIT_SCENES) + "/" + name);
}

std::vector<std::string> texts(const std::vector<Symbol>& symbols) {
  std::vector<std::string> result;
  for (const Symbol& symbol : symbols) result.push_back(to_text(symbol));
  return result;
}

constexpr MapGrid small{8, 6, 4};

using Names = std::vector<std::string>;

}  // namespace

BOOST_AUTO_TEST_CASE(digits_by_hand) {
  BOOST_TEST(digits_lost(2, 2) == 0);
  BOOST_TEST(digits_lost(1 + 0x1p-52, 1) == std::log10(2.0));
  // The error is 1e-6 to 2^-53/1e-6 = 1.1e-10 of itself, the logarithm has two roundings more.
  BOOST_TEST(std::abs(digits_lost(1 + 1e-6, 1) - (53 * std::log10(2.0) - 6)) < 1e-9);
  BOOST_TEST(digits_lost(7, 1) == 16);
  BOOST_TEST(std::isnan(digits_lost(std::numeric_limits<double>::infinity(), 1)));
}

BOOST_AUTO_TEST_CASE(what_varies) {
  BOOST_TEST(texts(stiffness_symbols(scene_named("zener.toml"))) == (Names{"k0", "k1"}));
  BOOST_TEST(texts(relaxation_symbols(scene_named("zener.toml"))) == Names{"c1"});
  BOOST_TEST(texts(stiffness_symbols(scene_named("elastic.toml"))) == Names{"kt"});
  BOOST_TEST(relaxation_symbols(scene_named("elastic.toml")).empty());
  BOOST_TEST(stiffness_symbols(scene_named("kelvin_rigid.toml")).empty());
  BOOST_TEST(relaxation_symbols(scene_named("prony.toml")).size() == 10U);
}

BOOST_AUTO_TEST_CASE(a_drive_without_springs_has_no_stiffness_ratio) {
  const Scene scene =
      test::scene_of({.network = "cd", .mass = "1 g", .elements = {{"kn", 1e7}, {"cd", 10}}});
  BOOST_TEST(stiffness_symbols(scene).empty());
}

// omega = sqrt(kd/m) = sqrt(2e6/5e-4), and sqrt((kt + kd)/m); bisection ends a rounding error away
// and each evaluation of the balance has three more: 8 x 2^-53 covers both, halved by the root.
BOOST_AUTO_TEST_CASE(resonances_of_the_elastic_drive_by_hand) {
  const Scene scene = scene_named("elastic_drive.toml");
  const Resonances resonances(scene);
  const Values values = resolve(scene).values();
  const auto relative = [&](ResonanceKind balance, double expected) {
    return std::abs(resonances.find(balance, values).value() / expected - 1);
  };
  BOOST_TEST(relative(ResonanceKind::resonance, std::sqrt(2e6 / 5e-4)) < 8 * 0x1p-53);
  BOOST_TEST(relative(ResonanceKind::antiresonance, std::sqrt(11.47e6 / 5e-4)) < 8 * 0x1p-53);
}

// Every layer against the rule for evaluations in doubles: 32 roundings times the condition number.
// Beside a resonance, 1e-8 off it, m omega^2/|D| = 0.5e8: the formula as it stands, which rounds
// m omega^2, loses more than five digits in some of the cells there (one whose rounding errors are
// all below a thousandth of 2^-53 would not). The contact's cells are the resonances' own.
BOOST_AUTO_TEST_CASE(a_cell_at_a_resonance_loses_what_its_conditioning_says) {
  const Scene scene = scene_named("elastic_drive.toml");
  const Driver driver(symbolic::derive(scene), *find_compiler());
  const auto scaled = stiffness_symbols(scene);
  const StabilityMap map = stability_map(scene, &driver, "stiffness", scaled, small);
  const Cells cells = cells_of(scene, scaled, small);
  BOOST_REQUIRE(map.layers.size() == 4U);
  double worst_beside = 0, worst_elsewhere = 0;
  cells.for_each(scene, [&](const Problem& each, std::size_t i) {
    const double condition = condition_number(each, cells.values[i]);
    for (const Layer& layer : map.layers)
      if (layer.key != "simulator" && !std::isnan(layer.lost[i]))
        BOOST_TEST(layer.lost[i] <= std::log10(32 * condition));
    double& worst = condition > 1e7 ? worst_beside : worst_elsewhere;
    for (const Layer& layer : map.layers)
      if (layer.key == "pasted") worst = std::max(worst, layer.lost[i]);
  });
  BOOST_TEST(worst_beside > 5);
  // The condition is at most 1e7 there, and but for cells beside the lines far below.
  BOOST_TEST(worst_elsewhere < 3);
}

BOOST_AUTO_TEST_CASE(lines_and_cells_lie_where_they_should) {
  const Scene scene = scene_named("elastic_drive.toml");
  const StabilityMap map =
      stability_map(scene, nullptr, "stiffness", stiffness_symbols(scene), small);
  BOOST_TEST(map.omega.size() == 8U);
  BOOST_TEST(map.factor.size() == 6U);
  BOOST_TEST(std::abs(std::log10(map.omega.back() / map.omega.front()) - 8) < 1e-12);
  for (const Layer& layer : map.layers) BOOST_TEST(layer.lost.size() == 48U);
  BOOST_REQUIRE(map.lines.size() == 2U);
  for (const auto& [omega, factor] : map.lines[0].points)
    BOOST_TEST(std::abs(omega / std::sqrt(2e6 / 5e-4) - 1) < 8 * 0x1p-53);
  for (const auto& [omega, factor] : map.lines[1].points)
    BOOST_TEST(std::abs(omega / std::sqrt((2e6 + factor * 9.47e6) / 5e-4) - 1) < 8 * 0x1p-53);
}

// v* certified is the truth; asked half as fast again above and below, the simulator answers what
// it should, so as to a wrong v* its answers are wrong.
BOOST_AUTO_TEST_CASE(wrong_answers_of_the_simulator_are_seen) {
  const Scene scene = scene_named("zener.toml");
  const double right = certified_critical_velocity(scene).value;
  BOOST_TEST(simulated_cell(scene, right).wrong == "");
  BOOST_TEST(simulated_cell(scene, 1.5 * right).wrong == "misses the stick below v*");
  BOOST_TEST(simulated_cell(scene, 0.5 * right).wrong == "sticks above v*");
  BOOST_TEST(std::isnan(simulated_cell(scene, std::numeric_limits<double>::infinity()).threshold));
}

// A Kelvin contact's damper takes over at high frequency: |K_n| grows without limit.
BOOST_AUTO_TEST_CASE(the_contact_stays_closed_in_every_cell) {
  const Scene scene = scene_named("kelvin.toml");
  const Cells cells = cells_of(scene, relaxation_symbols(scene), small);
  cells.for_each(scene, [&](const Problem& each, std::size_t) {
    BOOST_TEST(inadmissible_reasons(each).empty());
  });
}

BOOST_AUTO_TEST_CASE(a_scene_says_what_maps_it_does_not_have) {
  std::vector<std::string> left_out;
  BOOST_TEST(stability_maps(scene_named("measured_drive.toml"), nullptr, left_out).empty());
  BOOST_TEST(left_out.size() == 1U);
  left_out.clear();
  const auto maps = stability_maps(scene_named("elastic.toml"), nullptr, left_out);
  BOOST_REQUIRE(maps.size() == 1U);
  BOOST_TEST(maps[0].lines.empty());
  BOOST_TEST(left_out == Names{"No map over relaxation times: nothing relaxes."});
}

BOOST_AUTO_TEST_SUITE_END()
