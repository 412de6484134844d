// The page's section and the JSON of accuracy, cost and stability, of data made by hand.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "accuracy/pictures.hpp"
#include "report/document.hpp"
#include "report/records.hpp"

BOOST_AUTO_TEST_SUITE(test_accuracy_report)

using namespace vcrit::validation;
using namespace vcrit::validation::accuracy;

namespace {

EvaluatorError way(const std::string& key, double nanoseconds, double worst) {
  EvaluatorError result;
  result.key = key;
  result.name = "way <" + key + ">";
  result.measured = true;
  result.nanoseconds = nanoseconds;
  result.worst = worst;
  result.histogram.add(worst);
  return result;
}

Solve solve(const std::string& method, double seconds, double error) {
  Solve result;
  result.method = method;
  result.setting = "1e-8";
  result.answered = true;
  result.seconds = seconds;
  result.friction_ratio = 0.5;
  result.error = error;
  return result;
}

Accuracy example() {
  Accuracy all;
  all.command = "vcrit validate a&b.toml --out DIR";
  all.evaluators.seed = 7;
  all.evaluators.sets = 2;
  all.evaluators.symbols = {{"k"}, {"tau", 2}};
  all.evaluators.ways = {way("fast", 5, 0), way("pasted", 3, 4)};
  all.evaluators.ways[1].worst_inputs.push_back({{0.5, 3}, 1.25, 1, 4});
  EvaluatorError missing;
  missing.key = "accurate";
  missing.name = "generated, accurate";
  missing.failure = "not for this <scene>";
  all.evaluators.ways.push_back(missing);
  SpeedSolves speed;
  speed.ratio = 0.5;
  speed.friction_ratio = 0.5;
  speed.reference = "by hand";
  speed.solves = {solve("exact", 1e-5, 0), solve("rkf45", 1e-4, 1e-9)};
  speed.solves[1].failure = "wrong by hand";
  speed.solves[0].on_front = true;
  all.simulators = {speed};
  const double nan = std::nan("");
  all.maps = {{"stiffness",
               "k",
               {{"k"}},
               {1, 10},
               {0.1, 10},
               {{"formula", "Eq. 24 in doubles", {0, 1, 2, nan}, {{10, 10, "not finite"}}}},
               {{"resonance", {{3, 0.1}, {3, 10}}}}}};
  all.left_out = {"Nothing <relaxes>."};
  return all;
}

std::string section_of(const Accuracy& accuracy) {
  return report::rendered("accuracy", vcrit::record::page_of(accuracy));
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

BOOST_AUTO_TEST_CASE(json_holds_all_data) {
  const auto json = vcrit::record::json_of(example());
  BOOST_TEST(json["command"] == "vcrit validate a&b.toml --out DIR");
  const auto& evaluators = json["evaluators"];
  BOOST_TEST(evaluators["seed"] == 7);
  BOOST_TEST(!evaluators.contains("near_resonance"));
  BOOST_TEST(!evaluators.contains("compiler"));
  const auto& pasted = evaluators["ways"][1];
  BOOST_TEST(pasted["nanoseconds"] == 3);
  BOOST_TEST(pasted["histogram"]["counts"][3]["up_to"] == 4);
  BOOST_TEST(pasted["histogram"]["counts"][3]["sets"] == 1);
  const auto& worst = pasted["worst_inputs"][0];
  BOOST_TEST(worst["parameters"]["k"] == "0x1p-1");
  BOOST_TEST(worst["parameters"]["tau[2]"] == "0x1.8p+1");
  BOOST_TEST(worst["found"] == "0x1.4p+0");
  BOOST_TEST(worst["right"] == "0x1p+0");
  BOOST_TEST(evaluators["ways"][2]["failure"] == "not for this <scene>");
  BOOST_TEST(!evaluators["ways"][2].contains("nanoseconds"));
  BOOST_TEST(json["simulators"][0]["solves"][1]["failure"] == "wrong by hand");
  BOOST_TEST(json["simulators"][0]["solves"][0]["on_front"] == true);
  BOOST_TEST(!json["simulators"][0].contains("agreement"));
  const auto& map = json["maps"][0];
  BOOST_TEST(map["scaled"][0] == "k");
  BOOST_TEST(map["layers"][0]["digits_lost"][2] == 2);
  BOOST_TEST(map["layers"][0]["digits_lost"][3] == "nan");
  BOOST_TEST(map["layers"][0]["marks"][0]["angular_frequency"] == 10);
  BOOST_TEST(map["lines"][0]["points"][1][1] == 10);
  BOOST_TEST(json["left_out"][0] == "Nothing <relaxes>.");
}

BOOST_AUTO_TEST_CASE(the_page_shows_failures_worst_inputs_and_what_is_left_out) {
  const std::string html = section_of(example());
  BOOST_TEST(has(html, "not for this &lt;scene&gt;"));
  BOOST_TEST(!has(html, "<scene>"));
  BOOST_TEST(has(html, "wrong by hand"));
  BOOST_TEST(has(html, "k = 0x1p-1, tau[2] = 0x1.8p+1"));
  BOOST_TEST(has(html, "Nothing &lt;relaxes&gt;."));
  BOOST_TEST(has(html, "a&amp;b.toml"));
  for (const char* id :
       {"evaluator_errors", "evaluator_histogram", "simulators_050", "map_stiffness_formula"})
    BOOST_TEST(has(html, std::string("id=\"") + id + "\""), id);
}

BOOST_AUTO_TEST_CASE(what_all_maps_show_is_said_once) {
  Accuracy all = example();
  all.maps[0].layers.push_back(all.maps[0].layers[0]);
  all.maps[0].layers[1].key = "fast";
  const std::string html = section_of(all),
                    once = "Each cell is one frequency and one factor on k;";
  BOOST_TEST(has(html, "id=\"map_stiffness_fast\""));
  BOOST_TEST((html.find(once) != html.npos && html.find(once) == html.rfind(once)));
  all.maps[0].layers = {{"formula", "Eq. 24 in doubles", {0, 0, 0, 0}, {}}};
  BOOST_TEST(!has(section_of(all), once));  // nothing to see in maps without a loss
}

BOOST_AUTO_TEST_CASE(numbers_have_no_e_of_programs) {
  Accuracy all = example();
  all.evaluators.ways[1].nanoseconds = 1.04e4;
  all.evaluators.ways[1].worst = 4.58e11;
  const std::string html = section_of(all);
  BOOST_TEST(has(html, "<td>10.4 µs</td><td>4.58 × 10¹¹</td>"));
}

BOOST_AUTO_TEST_CASE(a_scene_without_a_body_does_not_hear_of_resonance) {
  Accuracy all = example();
  all.maps[0].lines.clear();
  BOOST_TEST(!has(section_of(all), "resonance"));
  all.evaluators.near_resonance = 1;
  BOOST_TEST(has(section_of(all), "resonance"));
}

BOOST_AUTO_TEST_CASE(errors_of_0_are_on_the_logarithmic_axes) {
  for (const figures::Figure& figure : pictures(example()))
    for (const figures::FigureSeries& series : figure.series)
      for (const figures::Point& point : series.points) {
        BOOST_TEST(point.x > 0);
        BOOST_TEST(point.y > 0);
      }
}

BOOST_AUTO_TEST_CASE(failed_answers_are_crossed_out_and_off_the_lines) {
  const figures::Figure figure = simulator_picture(example().simulators[0]);
  for (const figures::FigureSeries& series : figure.series)
    BOOST_TEST((series.name != "rkf45"), series.name);
  BOOST_TEST(figure.series.back().name == "failed");
  BOOST_TEST((figure.series.back().style == figures::Style::crosses));
}

BOOST_AUTO_TEST_SUITE_END()
