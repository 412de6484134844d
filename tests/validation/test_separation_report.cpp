// The report on a contact that opens and on indenters: what is compared, and what its pictures
// show.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>

#include "answers/critical_onset.hpp"
#include "compare/agreement.hpp"
#include "critical/critical_velocity.hpp"
#include "report/document.hpp"
#include "report/indenter_figures.hpp"
#include "report/records.hpp"
#include "report/report_json.hpp"
#include "report/scene_page.hpp"
#include "report/separation_figures.hpp"
#include "report/verdict.hpp"
#include "scene/scene.hpp"
#include "simulation/steady/exact.hpp"

BOOST_AUTO_TEST_SUITE(test_separation_report)

using namespace vcrit;
using namespace vcrit::validation;

namespace {

SceneReport report_of(const Scene& scene) {
  Driver driver(symbolic::derive(scene));
  return agree(driver, driver.derivation(), [](const std::string&) {});
}

const std::string kinds = VCRIT_TEST_DATA "/../matrix/kinds/";

const Comparison& comparison(const SceneReport& report, const std::string& key) {
  const auto found = std::find_if(report.comparisons.begin(), report.comparisons.end(),
                                  [&](const Comparison& each) { return each.key == key; });
  BOOST_REQUIRE_MESSAGE(found != report.comparisons.end(), key);
  return *found;
}

std::set<std::string> keys(const SceneReport& report) {
  std::set<std::string> all;
  for (const Comparison& each : report.comparisons) all.insert(each.key);
  return all;
}

std::string text_of(const std::string& scene) {
  return parse_scene(read_scene(std::string(VCRIT_SCENES) + "/" + scene).text, scene).text;
}

Scene separating_with_memory() {
  std::string text = text_of("separation.toml");
  const std::string isotropic = "poisson    = 0.3";
  text.replace(text.find(isotropic), isotropic.size(), "tangential = \"kelvin(k0, c1)\"");
  return parse_scene(text, "separation.toml");
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_contact_that_opens) {
  const Scene scene = read_scene(std::string(VCRIT_SCENES) + "/separation.toml");
  const SceneReport report = report_of(scene);
  for (const char* key : {"balance", "simulation", "marched", "starts", "energy", "static_limit",
                          "small_amplitude", "quasi_static"})
    BOOST_TEST((outcome(comparison(report, key)) == Comparison::Outcome::passed), key);
  const Separation& separation = report.separation.value();
  BOOST_TEST(separation.opens);
  BOOST_TEST(separation.closed_form);
  BOOST_TEST(separation.derivation.size() == 2u);
  // Each curve, at its own amplitude, ends in full friction at v*; the largest one begins near 0.
  for (const FrictionCurve& curve : separation.curves) {
    BOOST_TEST(std::abs(curve.friction.back() - 1) <= 1e-12);
    for (std::size_t i = 1; i < curve.friction.size(); ++i)
      BOOST_TEST(curve.friction[i] - curve.friction[i - 1] >= -1e-12);
  }
  BOOST_TEST(separation.curves.back().friction.front() < 0.05);
  // Few enough to be told apart, by what a scene says.
  std::vector<std::string> names;
  for (const FrictionCurve& curve : separation.curves) {
    names.push_back(curve.name);
    BOOST_TEST(curve.own == (curve.name == "1.5 µm, this scene"));
  }
  const std::vector<std::string> expected{"0.198 µm, closed", "0.397 µm, opens",
                                          "1.5 µm, this scene", "3.97 µm"};
  BOOST_TEST(names == expected, boost::test_tools::per_element());
}

// The map against a motion simulated here.
BOOST_AUTO_TEST_CASE(the_map_of_states) {
  const Scene scene = read_scene(std::string(VCRIT_SCENES) + "/separation.toml");
  const StateMap map = report_of(scene).separation.value().map;
  const std::size_t row = map.rows.size() / 3, columns = map.phases.size();
  BOOST_REQUIRE(map.motions.size() == map.rows.size() * columns);
  const auto state = simulation::steady_state(simulation::system_of(scene),
                                              map.rows[row] * critical_velocity(scene),
                                              simulation::Start::sliding, 180);
  BOOST_REQUIRE(state.cycle.size() == columns);
  int apart = 0, stuck = 0;
  for (std::size_t i = 0; i + 1 < columns; ++i) {
    const auto motion = map.motions[row * columns + i].value();
    // Samples stand at the cells' edges: a cell between two samples of one kind is of that kind.
    const auto& before = state.cycle[i];
    const auto& after = state.cycle[i + 1];
    if (before.friction_bound == 0 && after.friction_bound == 0) {
      BOOST_TEST((motion == simulation::Motion::separated));
      ++apart;
    } else if (before.friction_bound > 0 && after.friction_bound > 0 &&
               before.contact_velocity == 0 && after.contact_velocity == 0) {
      BOOST_TEST((motion == simulation::Motion::stick));
      ++stuck;
    }
  }
  BOOST_TEST(apart > 20);
  BOOST_TEST(stuck > 20);
}

// What has no steady state is no motion: nothing is drawn, and null is written.
BOOST_AUTO_TEST_CASE(a_row_without_an_answer_stays_empty) {
  SceneReport report(separating_with_memory());
  report.separation.emplace();
  StateMap& map = report.separation->map;
  map.rows = {0.5, 1};
  map.phases = {1, 2};
  map.motions = {simulation::Motion::stick, simulation::Motion::separated, std::nullopt,
                 std::nullopt};
  const auto figure = report::state_figure(*report.separation);
  BOOST_TEST(figure.map->values[1] == 2);
  BOOST_TEST(std::isnan(figure.map->values[2]));
  const auto states = report::scene_json({report, {}})["separation"]["state_map"]["states"];
  BOOST_TEST(states.dump() == "[[\"stick\",\"apart\"],[null,null]]");
}

BOOST_AUTO_TEST_CASE(without_closed_form) {
  const SceneReport report = report_of(separating_with_memory());
  BOOST_TEST((outcome(comparison(report, "simulation")) == Comparison::Outcome::passed));
  BOOST_TEST(comparison(report, "simulation").expected ==
             report.separation.value().critical_velocity);
  BOOST_TEST(!keys(report).contains("balance"));
  BOOST_TEST(!keys(report).contains("evaluators"));
  Comparison off = comparison(report, "simulation");
  off.found *= 1 + 1e-8;
  BOOST_TEST((outcome(off) == Comparison::Outcome::failed));
  BOOST_TEST(passed(report));
  BOOST_TEST(!report.separation.value().closed_form);
  BOOST_TEST(report::velocity_words(report).find("simulated") != std::string::npos);
  const std::string section =
      report::rendered("separation", record::page_of(report.separation.value()));
  BOOST_TEST(section.find("Eq. (24) does not apply") != std::string::npos);
}

// Where `vcrit eval` refuses to say v* the page says none, and nothing on it is green.
BOOST_AUTO_TEST_CASE(where_the_program_answers_no_velocity_the_page_has_none) {
  for (const bool isotropic : {false, true}) BOOST_TEST_CONTEXT(isotropic) {
      Scene scene = read_scene(kinds + "lossy.toml");
      scene.separation = true;
      scene.amplitude.value = 1.2e-6;  // of 0.5 and 0.8 um: the contact opens
      if (isotropic) scene.tangential = Isotropic{Isotropic::By::ratio, {{"r"}, 0.8}};
      BOOST_CHECK_THROW(critical_onset(scene), ModelError);
      const SceneReport report = report_of(scene);
      BOOST_TEST(report::velocity_words(report) == "");
      BOOST_TEST(report::state_class(report) == "outside");
      BOOST_REQUIRE(!report.reasons.empty());
      BOOST_TEST(report.reasons.front().find("is not causal") != std::string::npos);
      const std::string page = report::scene_page({report, {}}, {});
      for (const char* part : {"v* = ", "Critical speed v*"})
        BOOST_TEST(page.find(part) == std::string::npos, part);
      BOOST_TEST(page.find("<h1>No answer") != std::string::npos);
      BOOST_TEST(report::evidence_page({report, {}}, {}).find("badge passed") == std::string::npos);
    }
}

// Why the contact sticks at any speed: the spring along the surface starts from 0 at each meeting
// while the bound jumps, and a swing that the force drives in resonance grows until sticks stop it.
BOOST_AUTO_TEST_CASE(without_a_finite_velocity_motion_shows_that_there_is_none) {
  for (const char* kind : {"separation_jump", "separation_free_harmonic"})
    BOOST_TEST_CONTEXT(kind) {
      const SceneReport report = report_of(read_scene(kinds + kind + ".toml"));
      BOOST_TEST(std::isinf(report.separation.value().critical_velocity));
      for (const char* key : {"simulation", "marched"})
        BOOST_TEST((outcome(comparison(report, key)) == Comparison::Outcome::passed), key);
      const std::string& why = comparison(report, "simulation").reference;
      const bool jumps = why.find("the normal force jumps") != std::string::npos;
      BOOST_TEST(jumps == (std::string(kind) == "separation_jump"));
    }
}

// v* that is finite, said to be none: both see that it slides.
BOOST_AUTO_TEST_CASE(an_infinite_velocity_that_is_none_is_red) {
  const Border endless{HUGE_VAL, HUGE_VAL, 0, "no v*"};
  const simulation::System system = simulation::system_of(separating_with_memory());
  BOOST_TEST((outcome(compare_stick_without_end(endless, system)) == Comparison::Outcome::failed));
  BOOST_TEST((outcome(compare_march_without_end(endless, system)) == Comparison::Outcome::failed));
}

// Eq. 24 has its resonance at the frequency itself, and 0 at its antiresonance; the motion of
// a contact that opens has neither to do with, and its v* is witnessed all the same.
BOOST_AUTO_TEST_CASE(where_the_formula_is_zero_a_simulated_velocity_has_its_witnesses) {
  Scene scene = read_scene(kinds + "antiresonance.toml");
  scene.separation = true;
  scene.amplitude.value = 1.2e-6;
  const SceneReport report = report_of(scene);
  BOOST_TEST(report.critical_velocity == 0);
  BOOST_TEST(report.separation.value().critical_velocity > 0);
  for (const char* key : {"simulation", "marched", "starts"})
    BOOST_TEST((outcome(comparison(report, key)) == Comparison::Outcome::passed), key);
}

// An elastic sphere: friction at rest is (1 - D)^(3/2)/<(1 + D sin t)^(3/2)>.
BOOST_AUTO_TEST_CASE(below_an_indenter) {
  std::string text = text_of("sphere.toml");
  const std::string network = "zener(E0, E1, c1)", amplitude = "0.2 um";
  const SceneReport report = report_of(parse_scene(text, "sphere.toml"));
  for (const char* key : {"balance", "simulation", "evaluators", "marched", "starts",
                          "static_limit", "small_amplitude", "quasi_static"})
    BOOST_TEST((outcome(comparison(report, key)) == Comparison::Outcome::passed), key);
  text.replace(text.find(network), network.size(), "spring(E0)");
  text.replace(text.find(amplitude), amplitude.size(), "0.3 um");
  const SceneReport elastic = report_of(parse_scene(text, "sphere.toml"));
  BOOST_TEST(!keys(elastic).contains("quasi_static"));
  double mean = 0;
  constexpr int nodes = 256;  // the mean of a smooth period: exact to rounding
  for (int i = 0; i < nodes; ++i)
    mean += std::pow(1 + 0.3 * std::sin(2 * std::numbers::pi * i / nodes), 1.5) / nodes;
  const Comparison& rest = comparison(elastic, "static_limit");
  // Two quadratures to 1e-10, and a tolerance of the report below 1e-7.
  BOOST_TEST(std::abs(rest.expected - std::pow(0.7, 1.5) / mean) <= 1e-9);
  BOOST_TEST(std::abs(rest.found - std::pow(0.7, 1.5) / mean) <= 1e-7);
  const Indented& indented = elastic.indented.value();
  BOOST_TEST(indented.shapes.size() == 5u);
  // The sphere is the parabola of any radius; drawn to 1e-6 each.
  for (std::size_t i = 0; i < indented.shapes[1].friction.size(); ++i)
    BOOST_TEST(std::abs(indented.shapes[1].friction[i] - indented.shapes[4].friction[i]) <= 2e-6);
  // At the rim the contact opens, in the middle they do not.
  const auto rim = indented.map.motions.end() - static_cast<long>(indented.map.phases.size());
  BOOST_TEST((std::count(rim, indented.map.motions.end(), simulation::Motion::separated) > 0));
  BOOST_TEST(
      (std::count(indented.map.motions.begin(),
                  indented.map.motions.begin() + static_cast<long>(indented.map.phases.size()),
                  simulation::Motion::separated) == 0));
  for (const auto& figure : report::indenter_figures(indented))
    BOOST_TEST((!figure.series.empty() || figure.map.has_value()), figure.name);
}

BOOST_AUTO_TEST_CASE(plain_scenes_say_nothing_of_it) {
  const SceneReport report =
      report_of(read_scene(std::string(VCRIT_SCENES) + "/kelvin_rigid.toml"));
  const auto json = report::scene_json({report, {}});
  BOOST_TEST(!json.contains("separation"));
  BOOST_TEST(!json.contains("indenter"));
  const std::string page = report::scene_page({report, {}}, {});
  BOOST_TEST(page.find("A contact that opens") == std::string::npos);
  BOOST_TEST(page.find("Below the indenter") == std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
