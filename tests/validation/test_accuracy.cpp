// Accuracy, cost and stability of whole scenes: everything is there, and nothing that the scene
// does not have.
#include "accuracy/accuracy.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include "report/document.hpp"
#include "report/records.hpp"
#include "scene/scene.hpp"

BOOST_AUTO_TEST_SUITE(test_accuracy)

using namespace vcrit;
using namespace vcrit::validation;

namespace {

accuracy::Accuracy measured(const std::string& name) {
  const Scene scene = read_scene(std::string(VCRIT_SCENES) + "/" + name);
  Driver driver(symbolic::derive(scene));
  return accuracy::measure(driver, [](const std::string&) {});
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_elastic_scene_has_all_but_relaxation_and_hears_of_no_mass) {
  const accuracy::Accuracy all = measured("elastic.toml");
  BOOST_TEST(all.evaluators.sets == 4096U);
  BOOST_TEST(all.evaluators.ways.size() == 10U);
  // Five products and quotients without cancellation: no evaluator loses more than a few units.
  for (const accuracy::EvaluatorError& way : all.evaluators.ways) BOOST_TEST(way.worst <= 8);
  BOOST_TEST(all.simulators.size() == 3U);
  BOOST_REQUIRE(all.maps.size() == 1U);
  BOOST_TEST(all.maps[0].layers.size() == 4U);
  for (const accuracy::Layer& layer : all.maps[0].layers) {
    BOOST_TEST(layer.lost.size() == 32U * 24U);
    BOOST_TEST(layer.marks.empty(), layer.name);
  }
  const std::string html = report::rendered("accuracy", record::page_of(all));
  const std::string json = record::json_of(all).dump();
  BOOST_TEST(!has(json, "null"));
  for (const char* word : {"mass", " body", "resonance", "K_d", "drive"}) {
    BOOST_TEST(!has(html, word), word);
    BOOST_TEST(!has(json, word), word);
  }
}

// Its table is in the code, and in the formula as it is typed in.
BOOST_AUTO_TEST_CASE(of_a_measured_drive_all_evaluators_are_measured) {
  const accuracy::Accuracy all = measured("measured_drive.toml");
  BOOST_REQUIRE(all.evaluators.ways.size() == 10U);
  for (const accuracy::EvaluatorError& way : all.evaluators.ways)
    BOOST_TEST(way.measured, way.name << ": " << way.failure);
  BOOST_TEST(!all.simulators.empty());
  BOOST_TEST(all.maps.empty());
  BOOST_TEST(all.left_out.size() == 1U);
}

BOOST_AUTO_TEST_CASE(a_scene_that_is_not_admissible_is_not_simulated) {
  const accuracy::Accuracy all = measured("inadmissible.toml");
  BOOST_TEST(all.simulators.empty());
  for (const accuracy::StabilityMap& map : all.maps)
    for (const accuracy::Layer& layer : map.layers) BOOST_TEST(layer.key != "simulator");
  BOOST_TEST(has(all.left_out.at(0), "No simulations: the contact opens"));
}

BOOST_AUTO_TEST_SUITE_END()
