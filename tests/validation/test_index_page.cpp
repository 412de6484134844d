// A line a scene, red where something failed, and names of pages that no two scenes share.
#include "report/index_page.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include "report/assets.hpp"
#include "report/document.hpp"
#include "validation/example_report.hpp"

BOOST_AUTO_TEST_SUITE(test_index_page)

using namespace vcrit::validation;
using namespace vcrit::validation::report;

namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

IndexEntry entry(const SceneReport& report, const std::string& page) {
  return {scene_line(report), page};
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_failed_comparison_makes_its_line_red_and_is_named) {
  SceneReport report = example::scene_report(example::rigid_scene);
  const SceneReport good = report;
  report.comparisons[1].found *= 1.001;
  const std::string html =
      index_page({entry(good, "a.html"), entry(report, "b.html")}, example::origin());
  BOOST_TEST(has(html, "Do not use the numbers of scenes marked red: 1 of 4 checks failed."));
  BOOST_TEST(has(html, "<li class=\"passed\"><a href=\"a.html\">"));
  BOOST_TEST(has(html, "<li class=\"failed\"><a href=\"b.html\">"));
  BOOST_TEST(
      has(html, "<strong>1 of 2 comparisons failed</strong> <small>way called simulation</small>"));
}

BOOST_AUTO_TEST_CASE(a_line_says_the_answer) {
  SceneReport report = example::scene_report(example::rigid_scene, "folder/pad.toml");
  SceneReport outside = report;
  outside.reasons = {"the contact opens"};
  outside.effect->largest_closed_amplitude = 1e-7 / 3;
  const std::string html =
      index_page({entry(report, "a.html"), entry(outside, "b.html")}, example::origin());
  BOOST_TEST(has(html, "2 scenes. 1 answered, 1 outside the model, 0 checks failed."));
  BOOST_TEST(has(html,
                 "<code>pad.toml</code><span class=\"what\">4.578 mm/s</span>"
                 "<span class=\"reduction\">−40 %</span><span class=\"frequency\">20 kHz</span>"));
  BOOST_TEST(has(html, "contact would open above 33.3 nm (now 0.1 µm)"));
  // From 0.6 at rest, 4 + 22 x 0.4 pixels down, to full friction at the top.
  BOOST_TEST(has(html, "<path d=\"M0.0 12.8L"));
  BOOST_TEST(has(html, " 4.0\"/><circle"));
}

BOOST_AUTO_TEST_CASE(a_path_that_creeps_has_no_lowest_friction) {
  SceneReport report = example::scene_report(example::rigid_scene);
  report.creep_velocity = 1e-4;
  report.effect->lowest.reset();
  const std::string html = index_page({entry(report, "a.html")}, example::origin());
  BOOST_TEST(has(html, "<span class=\"reduction\">creeps</span>"));
}

BOOST_AUTO_TEST_CASE(text_from_a_scene_stays_text) {
  vcrit::Scene scene = vcrit::parse_scene(example::rigid_scene, "scene.toml");
  scene.title = "</li><img src=x>";
  const SceneReport report = example::scene_report(scene);
  const std::string html = index_page({entry(report, "a.html")}, example::origin());
  BOOST_TEST(!has(html, "<img"));
  BOOST_TEST(has(html, "&lt;/li&gt;&lt;img src=x&gt;"));
}

BOOST_AUTO_TEST_CASE(the_filter_alone_runs_and_nothing_is_loaded) {
  const SceneReport report = example::scene_report(example::rigid_scene);
  const std::string html = index_page({entry(report, "a.html")}, example::origin());
  BOOST_TEST(has(html, "default-src 'none'"));
  BOOST_TEST(has(html, "script-src '" + script_hash(index_script()) + "'"));
  BOOST_TEST(!has(html, "http:"));
  BOOST_TEST(!has(html, "https:"));
}

BOOST_AUTO_TEST_CASE(pages_have_names_of_their_own) {
  const std::vector<std::string> files{"a/zener.toml", "b/zener.toml", "Zener.toml",
                                       "index.toml",   "../.toml",     "a b<c>/d&é.toml"};
  const std::vector<std::string> expected{"zener",   "zener-2", "Zener-3",
                                          "index-2", "_toml",   "d___"};
  const std::vector<std::string> names = page_names(files);
  BOOST_TEST(names == expected, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_line_comes_back_as_it_went) {
  vcrit::Scene scene = vcrit::parse_scene(example::rigid_scene, "scene.toml");
  scene.warnings = {"odd \xC3\xA9 \"one\""};
  SceneReport report = example::scene_report(scene);
  report.comparisons[1].found *= 1.001;
  const SceneLine line = scene_line(report), again = scene_line(vcrit::record::json_of(line));
  BOOST_TEST(again.file == line.file);
  BOOST_TEST(again.title == "Elastic contact");
  BOOST_TEST(again.state == "failed");
  BOOST_TEST(again.made == 2u);
  BOOST_TEST(again.failed == line.failed, boost::test_tools::per_element());
  BOOST_TEST(again.warnings == scene.warnings, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
