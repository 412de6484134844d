// The page stands alone, runs nothing but its own scripts, shows what is there and nothing else.
#include "report/scene_page.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include "compare/velocity_comparisons.hpp"
#include "record/html_text.hpp"
#include "record/json_text.hpp"
#include "report/answer_figures.hpp"
#include "report/assets.hpp"
#include "report/cycle_figures.hpp"
#include "report/document.hpp"
#include "report/html.hpp"
#include "report/verdict.hpp"
#include "support/patterns.hpp"
#include "validation/example_report.hpp"

BOOST_AUTO_TEST_SUITE(test_scene_page)

using namespace vcrit::validation;
using namespace vcrit::validation::report;

namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

/// The page as it is read: without scripts (but with the charts' data), style and the simulator,
/// whose digits spell any word by chance.
std::string without_code(std::string html) {
  for (const std::string_view script : scripts()) {
    const auto at = html.find(script);
    BOOST_REQUIRE(at != html.npos);
    html.erase(at, script.size());
  }
  for (const std::string_view script : explorer_scripts())
    if (const auto at = html.find(script); at != html.npos) html.erase(at, script.size());
  for (const std::string_view each : {style(), explorer_style()})
    if (const auto at = html.find(each); at != html.npos) html.erase(at, each.size());
  const std::string simulator = "id=\"simulator-module\">";
  if (auto at = html.find(simulator); at != html.npos) {
    at += simulator.size();
    html.erase(at, html.find('<', at) - at);
  }
  return html;
}

std::string page_of(const SceneReport& report) {
  return without_code(scene_page({report, {}}, example::origin()));
}

std::string evidence_of(const SceneReport& report) {
  return without_code(evidence_page({report, {}}, example::origin()));
}

std::string policy(const std::string& html) {
  const auto found = vcrit::test::matches(
      html, "<meta http-equiv=\"Content-Security-Policy\" content=\"([^\"]*)\">");
  BOOST_REQUIRE(!found.empty());
  return found.front()[1];
}

const std::string hostile = "</script><img src=x onerror=alert(1)> & \"quotes\" 'too'";

}  // namespace

BOOST_AUTO_TEST_CASE(nothing_is_loaded_from_outside) {
  const std::string name_of_mathml =
      "xmlns=\"http://www.w3.org/1998/Math/MathML\"";  // loads nothing
  const std::string html = vcrit::test::without_matches(
      page_of(example::scene_report(example::driven_scene)), name_of_mathml);
  BOOST_TEST(!has(html, "http:"));
  BOOST_TEST(!has(html, "https:"));
  BOOST_TEST(!has(html, " src="));
  BOOST_TEST(!has(html, "<link"));
  const std::string outward = "href=\"(?!#|evidence\\.html\"|report\\.json\")";
  BOOST_TEST(!vcrit::test::has_match(html, outward));
  BOOST_TEST(vcrit::test::has_match("<a href=\"index.html\">", outward));
  BOOST_TEST(!has(std::string(style()), "url("));
  BOOST_TEST(!has(std::string(style()), "@import"));
}

BOOST_AUTO_TEST_CASE(the_policy_lets_only_the_pages_scripts_run) {
  const std::string text =
      policy(scene_page({example::scene_report(example::rigid_scene), {}}, example::origin()));
  BOOST_TEST(has(text, "default-src 'none'"));
  BOOST_TEST(!has(text, "'unsafe-eval'"));
  const std::string scripts_part =
      text.substr(text.find("script-src"), text.find("; style-src") - text.find("script-src"));
  BOOST_TEST(!has(scripts_part, "unsafe-inline"));
  for (const std::string_view script : scripts())
    BOOST_TEST(has(scripts_part, "'" + script_hash(script) + "'"));
}

// SHA-256 of nothing and of "abc" (FIPS 180-2, B.1), in base 64 as browsers print it.
BOOST_AUTO_TEST_CASE(hashes_are_written_as_browsers_read_them) {
  BOOST_TEST(script_hash("") == "sha256-47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU=");
  BOOST_TEST(script_hash("abc") == "sha256-ungWv48Bz+pBQUDeXa4iI7ADYaOWF3qctBD/YfIAFa0=");
}

BOOST_AUTO_TEST_CASE(no_script_can_end_early) {
  for (const std::string_view script : scripts()) {
    BOOST_TEST(!has(std::string(script), "</script"));
    BOOST_TEST(!has(std::string(script), "<!--"));
  }
}

BOOST_AUTO_TEST_CASE(text_from_a_scene_stays_text) {
  vcrit::Scene scene = vcrit::parse_scene(example::rigid_scene, "odd <file>.toml");
  scene.title = hostile;
  scene.text += "# " + hostile;
  scene.warnings = {hostile};
  SceneReport report = example::scene_report(scene);
  report.reasons = {hostile};
  report.comparisons[0].name = report.comparisons[0].reason = report.comparisons[0].detail =
      hostile;
  report.effect->kind = vcrit::Effect::Kind::outside;
  report.effect->reasons = {hostile};
  report.limits[0].name = report.derivation[0].words = report.formula.formula.latex = hostile;
  const std::string html = page_of(report) + evidence_of(report);
  BOOST_TEST(!has(html, "<img"));
  BOOST_TEST(!has(html, "<file>"));
  BOOST_TEST(has(
      html,
      "&lt;/script&gt;&lt;img src=x onerror=alert(1)&gt; &amp; &quot;quotes&quot; &#39;too&#39;"));
}

BOOST_AUTO_TEST_CASE(escaping_survives_what_is_no_text) {
  BOOST_TEST(vcrit::record::html_text("a\xFFz") == "a\xEF\xBF\xBDz");
  BOOST_TEST(vcrit::record::html_text(std::string("a\0z", 3)) == "a\xEF\xBF\xBDz");
  BOOST_TEST(vcrit::record::html_text("two\r\nlines\tand µ") == "two\nlines\tand µ");
}

BOOST_AUTO_TEST_CASE(json_in_the_page_cannot_end_its_element) {
  const nlohmann::ordered_json value{{"key", "</script><!--"}};
  const std::string text = json_for_page(value);
  BOOST_TEST(!has(text, "<"));
  BOOST_TEST((vcrit::record::read_json(text) == value));
}

BOOST_AUTO_TEST_CASE(a_rigid_massless_scene_has_neither_mass_nor_drive) {
  const std::string html = vcrit::test::without_matches(
      page_of(example::scene_report(example::rigid_scene)), "</?t?body>");
  BOOST_TEST(!has(html, "mass"));
  BOOST_TEST(!has(html, "drive"));
  BOOST_TEST(!has(html, "body"));
}

BOOST_AUTO_TEST_CASE(sections_without_content_are_left_out) {
  SceneReport report = example::scene_report(example::rigid_scene);
  const std::string with[] = {"id=\"friction_over_speed\"", "id=\"cycle\"", "id=\"limits\"",
                              "id=\"sensitivities\""};
  for (const std::string& part : with) BOOST_TEST(has(page_of(report), part));
  report.curve.clear();
  report.effect->lowest.reset();
  report.cycle.reset();
  report.limits.clear();
  report.influences.clear();
  const std::string html = page_of(report);
  for (const std::string& part : with) BOOST_TEST(!has(html, part));
  BOOST_TEST(!has(html, "creep"));
}

// Without any script: the sentence, the curve, the system, the numbers.
BOOST_AUTO_TEST_CASE(the_answer_comes_first_and_needs_no_script) {
  const std::string html = page_of(example::scene_report(example::rigid_scene));
  const auto sentence =
      html.find("<h1>Vibration lowers friction below 4.578\u00a0mm/s, by at most 40\u00a0%.");
  const auto chart = html.find("<svg class=\"still\"");
  const auto system = html.find("<svg class=\"drawing\"");
  const auto numbers = html.find("<dd title=\"0.0045779 m/s\">4.578\u00a0mm/s</dd>");
  const auto sure = html.find("How sure");
  const auto formula = html.find("id=\"formula\"");
  BOOST_TEST((sentence < chart && chart < system && system < numbers && numbers < sure &&
              sure < formula && formula != html.npos));
  BOOST_TEST(has(html, "<dd title=\"0.6\">0.6</dd>"));
  // du_z 0.1 µm, a third of the mean force: closed up to the threefold.
  BOOST_TEST(has(html, ">0.3\u00a0µm</dd><dd class=\"note\">now 0.1\u00a0µm</dd>"));
  // Half of 4.578 mm/s, against 0.9 x 0.3 x 3.45 N.
  BOOST_TEST(has(html, ">2.132\u00a0mW</dd>"));
}

BOOST_AUTO_TEST_CASE(the_inputs_decide) {
  const std::string html = page_of(example::scene_report(example::rigid_scene));
  // As mathematics, and no number parted from its sign.
  BOOST_TEST(
      has(html,
          "10\u00a0% in <math><mi>M</mi></math> is 10\u00a0% in "
          "<math><msup><mi>v</mi><mo>*</mo></msup></math>; 10\u00a0% in "
          "<math><mi>T</mi></math> and <math><mi>N</mi></math> together at most 7.5\u00a0%."));
  BOOST_TEST(has(html, "2\u00a0checks passed: the closest used 0.1\u00a0% of its tolerance."));
  BOOST_TEST(has(html, "<span class=\"down\" style=\"margin-left: 25.0%; width: 25.0%\">"));
  BOOST_TEST(has(html, ">−5\u00a0%</td>"));
}

// Beside the chart its words would be too small.
BOOST_AUTO_TEST_CASE(a_wide_system_has_a_row_of_its_own) {
  const std::string narrow = "<div class=\"first\">", wide = "<div class=\"first wide\">";
  const std::string html = page_of(example::scene_report(example::rigid_scene));
  BOOST_TEST((has(html, narrow) && !has(html, wide)));
  const std::string film = page_of(example::scene_report(
      "title = \"Film\"\n" +
      vcrit::test::to_toml({.normal = "zener(kn, kn1, cn1)",
                            .tangential = "k1 - c1 - k2 - c2 - k1 - c1 - k2 - c2",
                            .network = "kd | cd",
                            .frequency = "30 kHz",
                            .amplitude = "50 nm",
                            .indentation = "0.4 um",
                            .coefficient = 0.15,
                            .elements = {{"kn", 1e7},
                                         {"kn1", 3e6},
                                         {"cn1", 15},
                                         {"k1", 6e6},
                                         {"c1", 8000},
                                         {"k2", 9e6},
                                         {"c2", 45},
                                         {"kd", 4e6},
                                         {"cd", 5}}})));
  BOOST_TEST((has(film, wide) && !has(film, narrow)));
}

BOOST_AUTO_TEST_CASE(what_nobody_reads_is_not_written_out) {
  SceneReport report = example::scene_report(example::rigid_scene);
  report.influences[2].share = -8e-6;  // 8e-05 % for 10 %
  BOOST_TEST(has(page_of(report), ">&lt;\u00a00.001\u00a0%</td>"));
  for (Comparison& comparison : report.comparisons)
    comparison.found = comparison.expected * (1 + 5e-15);
  BOOST_TEST(checks_words(report) ==
             "2 checks passed: the closest used less than 0.01 % of its tolerance.");
  for (Comparison& comparison : report.comparisons) comparison.found = comparison.expected;
  BOOST_TEST(checks_words(report) == "2 checks passed, without any difference.");
}

// Whatever the speeds at other frequencies.
BOOST_AUTO_TEST_CASE(speeds_over_frequency_have_the_unit_of_the_answer) {
  SceneReport report = example::scene_report(example::rigid_scene);
  for (const double part : {0.01, 0.02, 0.05, 1.0, 2.0})
    report.response.points.push_back({125664 * part, 1, 1, {}, 0.0045779 * part, true});
  BOOST_TEST(frequency_figure(report)->y.title == "v*, mm/s");
  report.reasons = {"the contact opens"};
  BOOST_TEST(frequency_figure(report)->y.title == "v*, µm/s");
}

// Its events are at 3 and 5 rad, between its samples.
BOOST_AUTO_TEST_CASE(a_cycle_sticks_from_event_to_event) {
  SceneReport report = example::scene_report(example::rigid_scene);
  const double microseconds = 1e6 / 125664;
  const figures::Figure velocity = velocity_figure(report);
  BOOST_REQUIRE(velocity.bands.size() == 1u);
  BOOST_TEST(velocity.bands[0].from == 3 * microseconds, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(velocity.bands[0].to == 5 * microseconds, boost::test_tools::tolerance(1e-14));
  BOOST_TEST(velocity.bands[0].words == "sticks 32 %");  // 2/(2 pi)
  report.cycle->events = {{1, vcrit::simulation::Motion::slip},
                          {5, vcrit::simulation::Motion::stick}};
  report.cycle->regime = "stick-slip-apart";
  const figures::Figure over_the_end = velocity_figure(report);
  BOOST_REQUIRE(over_the_end.bands.size() == 2u);
  BOOST_TEST(over_the_end.bands[0].from == 0);
  BOOST_TEST(over_the_end.bands[1].words == "sticks 36 %");  // (1 + 2 pi - 5)/(2 pi)
  BOOST_TEST(over_the_end.caption.ends_with("stick-slip, and the contact opens."));
}

BOOST_AUTO_TEST_CASE(evidence_has_a_page_of_its_own) {
  const SceneReport report = example::scene_report(example::rigid_scene);
  BOOST_TEST(!has(page_of(report), "class=\"claims\""));
  const std::string html = evidence_of(report);
  BOOST_TEST(has(html, "v* from the formula = v* from stick-slip simulation"));
  BOOST_TEST(has(html, "not independent: the formula itself, Eq. (24)"));
  BOOST_TEST(has(html, "a reason for it"));
  BOOST_TEST(has(html, "<summary>16 digits</summary>"));
  BOOST_TEST(has(html, "id=\"friction_residual\"") == !report.methods.empty());
  BOOST_TEST(has(html, "A processor"));
}

BOOST_AUTO_TEST_CASE(a_long_list_of_limits_is_folded) {
  SceneReport report = example::scene_report(example::rigid_scene);
  const std::string folded = "<details><summary>5 limits</summary>";
  report.limits.resize(4, report.limits.front());
  BOOST_TEST(!has(page_of(report), "limits</summary>"));
  report.limits.resize(5, report.limits.front());
  BOOST_TEST(has(page_of(report), folded));
}

BOOST_AUTO_TEST_CASE(the_reduced_model_stands_where_it_applies) {
  SceneReport report = example::scene_report(example::rigid_scene);
  BOOST_TEST(!has(page_of(report), "<h2>The reduced model"));
  report.reduced_model = example::reduced_model();
  const std::string html = page_of(report);
  BOOST_TEST(has(html, "<h2>The reduced model"));
  BOOST_TEST(has(html, "at δ = 1.5, it may be used from v₀ = 0.62 v* on"));
  BOOST_TEST(has(html,
                 "<th scope=\"row\">0.3</th><td style=\"--heat: 83%\">+0.250</td>"
                 "<td style=\"--heat: 0%\">0</td></tr>"));
  BOOST_TEST(has(html,
                 "<tr class=\"own\"><th scope=\"row\">1.5<small>this scene</small></th>"
                 "<td style=\"--heat: 33%\">+0.100</td>"
                 "<td style=\"--heat: 0%\">-0.001</td></tr>"));
}

BOOST_AUTO_TEST_CASE(the_reduced_model_may_hold_everywhere_or_nowhere) {
  SceneReport report = example::scene_report(example::rigid_scene);
  report.reduced_model = example::reduced_model();
  report.reduced_model->usable_from = 0.01;
  BOOST_TEST(has(page_of(report), "it may be used at any speed: it is off by less than 0.01"));
  report.reduced_model->usable_from.reset();
  BOOST_TEST(has(page_of(report), "it is not to be used: it is off by more than 0.01"));
}

BOOST_AUTO_TEST_CASE(creep_is_named_where_there_is_some) {
  SceneReport report = example::scene_report(example::driven_scene);
  report.creep_velocity = 2e-3;
  BOOST_TEST(has(evidence_of(report), "v₀ / (v* + creep)"));
  BOOST_TEST(has(page_of(report), "with creep the drive runs at 6.578\u00a0mm/s"));
}

BOOST_AUTO_TEST_CASE(a_failed_comparison_is_red_above_everything) {
  SceneReport report = example::scene_report(example::rigid_scene);
  BOOST_TEST(!has(page_of(report), "failed-checks"));
  report.comparisons[1].found *= 1.001;
  const std::string html = page_of(report);
  const auto banner = html.find("Do not use these numbers: 1 of 2 checks failed.");
  BOOST_TEST((banner != html.npos && banner < html.find("<h1>")));
  BOOST_TEST(has(html, "<li>v* from the formula = v* from stick-slip simulation</li>"));
  BOOST_TEST(has(evidence_of(report), "badge failed\">failed"));
}

BOOST_AUTO_TEST_CASE(what_was_not_run_is_said_and_is_no_fault) {
  SceneReport report = example::scene_report(example::rigid_scene);
  report.comparisons[1].not_run = true;
  report.comparisons[1].detail = "no C++ compiler found";
  BOOST_TEST(has(page_of(report), "1\u00a0check passed"));
  BOOST_TEST(has(page_of(report), "1\u00a0could not be run"));
  BOOST_TEST(!has(page_of(report), "failed-checks"));
  BOOST_TEST(has(evidence_of(report), "no C++ compiler found"));
}

BOOST_AUTO_TEST_CASE(an_inadmissible_scene_says_why_and_shows_no_speed) {
  SceneReport report = example::scene_report(example::rigid_scene);
  report.reasons = {"the contact opens"};
  report.normal_force = {1.15, 3.45};
  report.effect->kind = vcrit::Effect::Kind::outside;
  report.effect->largest_closed_amplitude = 1e-7 / 3;
  report.curve.clear();
  report.cycle.reset();
  for (Comparison& comparison : report.comparisons) comparison.reference = formula_reference;
  const std::string html = page_of(report);
  BOOST_TEST(has(html, "<li>the contact opens</li>"));
  BOOST_TEST(has(html, "id=\"normal_force\""));
  BOOST_TEST(!has(html, "id=\"friction_over_speed\""));
  BOOST_TEST(!has(html, "Critical speed v*"));
  BOOST_TEST(has(html, ">33.33\u00a0nm</dd><dd class=\"note\">now 0.1\u00a0µm</dd>"));
  // The formula's number is no v*, and that ways to evaluate it agree is no good news.
  const std::string evidence = evidence_of(report);
  BOOST_TEST(!has(evidence, "badge passed"));
  BOOST_TEST(has(evidence, "<span class=\"badge outside\">agrees</span>"));
  BOOST_TEST(velocity_words(report) == "");
}

// A contact that opens, v* simulated: that ways to evaluate the formula agree is arithmetic alone.
BOOST_AUTO_TEST_CASE(a_formula_that_does_not_apply_passes_nothing) {
  SceneReport report = example::scene_report(example::rigid_scene);
  BOOST_TEST(has(evidence_of(report), "badge passed"));
  for (Comparison& comparison : report.comparisons) comparison.reference = formula_reference;
  BOOST_TEST(has(evidence_of(report), "badge passed"));
  report.formula_applies = false;
  BOOST_TEST(!has(evidence_of(report), "badge passed"));
  BOOST_TEST(has(evidence_of(report), "Equation (24) is not v* of this scene"));
}

BOOST_AUTO_TEST_CASE(a_fault_outside_the_model_is_red) {
  SceneReport report = example::scene_report(example::rigid_scene);
  report.reasons = {"the contact opens"};
  report.comparisons.front().found *= 2;
  BOOST_TEST(has(page_of(report), "Do not use these numbers"));
  BOOST_TEST(has(evidence_of(report), "badge failed"));
}

BOOST_AUTO_TEST_CASE(only_in_a_suite_is_there_a_way_to_the_others) {
  const SceneReport report = example::scene_report(example::rigid_scene);
  const std::string link = "<a href=\"index.html\">";
  BOOST_TEST(!has(page_of(report), link));
  BOOST_TEST(
      has(scene_page({report, {}}, example::origin(), {"a.html", "a.evidence.html", true}), link));
}

BOOST_AUTO_TEST_CASE(a_page_stays_below_two_megabytes) {
  const SceneReport report = example::scene_report(example::driven_scene);
  BOOST_TEST(scene_page({report, {}}, example::origin()).size() < 2000000u);
}

BOOST_AUTO_TEST_SUITE_END()
