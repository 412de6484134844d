// report.json: every number comes back, failures have names, absent things have no keys.
#include "report/report_json.hpp"

#include <boost/test/unit_test.hpp>
#include <limits>
#include <nlohmann/json.hpp>

#include "record/json_text.hpp"
#include "report/html.hpp"
#include "validation/example_report.hpp"

BOOST_AUTO_TEST_SUITE(test_report_json)

using namespace vcrit::validation;
using nlohmann::ordered_json;

namespace {

ordered_json parsed(const SceneReport& report) {
  return vcrit::record::read_json(
      report::report_json(example::origin(), {report::scene_json({report, {}})}));
}

}  // namespace

BOOST_AUTO_TEST_CASE(numbers_come_back_to_the_last_bit) {
  SceneReport report = example::scene_report(example::driven_scene);
  report.critical_velocity = 0.1 + 0.2;  // needs 17 digits
  report.comparisons[0].found = std::numeric_limits<double>::denorm_min();
  report.curve[3].from_rest = std::nextafter(1.0, 0.0);
  report.cycle->points[7].force = -1e-300 / 3;
  const ordered_json scene = parsed(report)["scenes"][0];
  BOOST_TEST(scene["critical_velocity"]["value"].get<double>() == 0.1 + 0.2);
  BOOST_TEST(scene["comparisons"][0]["found"].get<double>() ==
             std::numeric_limits<double>::denorm_min());
  BOOST_TEST(scene["friction_curve"][3]["friction_ratio_from_rest"].get<double>() ==
             std::nextafter(1.0, 0.0));
  BOOST_TEST(scene["cycle"]["points"][7]["force"].get<double>() == -1e-300 / 3);
}

BOOST_AUTO_TEST_CASE(what_json_has_no_number_for_is_a_word) {
  SceneReport report = example::scene_report(example::rigid_scene);
  report.critical_velocity = std::numeric_limits<double>::infinity();
  report.infinite_reason = "resonance";
  report.comparisons[0].found = std::numeric_limits<double>::quiet_NaN();
  const ordered_json scene = parsed(report)["scenes"][0];
  BOOST_TEST(scene["critical_velocity"]["value"] == "inf");
  BOOST_TEST(scene["critical_velocity"]["reason"] == "resonance");
  BOOST_TEST(scene["comparisons"][0]["found"] == "nan");
  BOOST_TEST(scene["comparisons"][0]["outcome"] == "failed");
}

BOOST_AUTO_TEST_CASE(failures_are_named) {
  SceneReport report = example::scene_report(example::rigid_scene);
  BOOST_TEST(parsed(report)["passed"] == true);
  BOOST_TEST(parsed(report)["scenes"][0]["failed"].empty());
  report.comparisons[1].found *= 1.001;
  const ordered_json object = parsed(report);
  BOOST_TEST(object["passed"] == false);
  BOOST_TEST(object["scenes"][0]["passed"] == false);
  BOOST_TEST(object["scenes"][0]["failed"] == ordered_json::array({"simulation"}));
}

BOOST_AUTO_TEST_CASE(a_comparison_that_was_not_run_has_no_numbers) {
  SceneReport report = example::scene_report(example::rigid_scene);
  report.comparisons[0].not_run = true;
  report.comparisons[0].detail = "no C++ compiler found";
  const ordered_json comparison = parsed(report)["scenes"][0]["comparisons"][0];
  BOOST_TEST(comparison["outcome"] == "not run");
  BOOST_TEST(comparison["detail"] == "no C++ compiler found");
  BOOST_TEST(!comparison.contains("found"));
}

BOOST_AUTO_TEST_CASE(a_rigid_massless_scene_has_neither_mass_nor_drive) {
  const std::string text = report::report_json(
      example::origin(), {report::scene_json({example::scene_report(example::rigid_scene), {}})});
  for (const char* absent : {"mass", "drive", "body", "\"m\"", "creep"})
    BOOST_TEST(text.find(absent) == text.npos, absent);
}

BOOST_AUTO_TEST_CASE(absent_parts_have_no_keys) {
  SceneReport report = example::scene_report(example::rigid_scene);
  report.curve.clear();
  report.cycle.reset();
  const ordered_json scene = parsed(report)["scenes"][0];
  BOOST_TEST(!scene.contains("friction_curve"));
  BOOST_TEST(!scene.contains("cycle"));
  BOOST_TEST(!scene.contains("compiler"));
  BOOST_TEST(scene["admissible"] == true);
}

BOOST_AUTO_TEST_CASE(the_reduced_model_has_its_table) {
  SceneReport report = example::scene_report(example::rigid_scene);
  BOOST_TEST(!parsed(report)["scenes"][0].contains("reduced_model"));
  report.reduced_model = example::reduced_model();
  const ordered_json model = parsed(report)["scenes"][0]["reduced_model"];
  BOOST_TEST(model["delta"].get<double>() == 1.5);
  BOOST_TEST(model["usable_from"].get<double>() == 0.62);
  BOOST_TEST(model["table"].size() == 4u);
  const ordered_json last = model["table"][3];
  BOOST_TEST(last["delta"].get<double>() == 1.5);
  BOOST_TEST(last["velocity_ratio"].get<double>() == 0.9);
  BOOST_TEST(last["reduced"].get<double>() == 0.5);
  BOOST_TEST(last["full"].get<double>() == 0.501);
  report.reduced_model->usable_from.reset();
  BOOST_TEST(parsed(report)["scenes"][0]["reduced_model"]["usable_from"].is_null());
}

BOOST_AUTO_TEST_CASE(the_command_can_be_pasted) {
  using report::shell_word;
  BOOST_TEST(shell_word("scenes/zener.toml") == "scenes/zener.toml");
  BOOST_TEST(shell_word("two words") == "'two words'");
  BOOST_TEST(shell_word("it's $(x)") == "'it'\\''s $(x)'");
  BOOST_TEST(shell_word("") == "''");
  BOOST_TEST(report::command({"a b.toml"}) == "vcrit validate 'a b.toml' --out report");
}

BOOST_AUTO_TEST_SUITE_END()
