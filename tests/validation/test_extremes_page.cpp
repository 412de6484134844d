// The page and the JSON file about extremes: sections, losses with their inputs, faults in red.
#include "report/extremes_page.hpp"

#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/files.hpp"
#include "record/json_text.hpp"
#include "report/validate_extremes.hpp"
#include "validation/example_report.hpp"
#include "validation/extreme_family.hpp"

BOOST_AUTO_TEST_SUITE(test_extremes_page)

using namespace vcrit;
using namespace vcrit::validation;
using namespace vcrit::validation::report;
using extremes::Claimed;

namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

ExtremesContents contents_of(const extremes::Subjects& subjects) {
  return {{example::origin().machine, extremes_command},
          example::extremes_of(example::elastic(subjects))};
}

const ExtremesContents& honest_contents() {
  static const ExtremesContents contents = contents_of(example::honest());
  return contents;
}

/// The resonance region's first value is off by more than its bound.
const ExtremesContents& faulty_contents() {
  static const ExtremesContents contents =
      contents_of(example::faulty("certified", [](Claimed& claimed, const accuracy::Cells& cells) {
        if (cells.omega.empty() && claimed.values.size() == 31) claimed.values.front() *= 2;
      }));
  return contents;
}

std::string section_of(const std::string& html, const std::string& id) {
  const auto begin = html.find("<section class=\"scene\" id=\"" + id + "\">");
  BOOST_REQUIRE(begin != html.npos);
  return html.substr(begin, html.find("</section>", begin) - begin);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_sections_are_there_in_order) {
  const std::string html = extremes_page(honest_contents());
  std::size_t at = html.find("class=\"verdict passed\"");
  BOOST_REQUIRE(at != html.npos);
  for (const char* id : {"judging", "relaxation", "stiffness", "corners", "resonance",
                         "antiresonance", "limits", "simulator"}) {
    const auto next = html.find(std::string("id=\"") + id + "\"", at);
    BOOST_TEST_REQUIRE(next != html.npos, id);
    at = next;
  }
  BOOST_TEST(!has(html, "comparisons failed"));
  BOOST_TEST(has(html, "vcrit validate --extremes --out report"));
  for (const char* map : {"library", "fast", "accurate", "simulator"})
    BOOST_TEST(has(section_of(html, "stiffness"), std::string("id=\"stiffness_") + map + "\""));
  BOOST_TEST(has(section_of(html, "resonance"), "id=\"elastic_resonance\""));
  BOOST_TEST(has(section_of(html, "antiresonance"), "<strong>6</strong> not certified"));
}

BOOST_AUTO_TEST_CASE(a_fault_is_red_and_names_region_and_inputs) {
  const std::string html = extremes_page(faulty_contents());
  BOOST_TEST(has(html, "class=\"verdict failed\""));
  const std::string resonance = section_of(html, "resonance");
  BOOST_TEST(has(resonance, "<details class=\"agreement\" open>"));
  BOOST_TEST(has(resonance, "beyond its bound"));
  BOOST_TEST(has(resonance, "0x1.ccccccccccccdp+0"));  // omega = 2 (1 - 0.1)
  BOOST_TEST(!has(section_of(html, "stiffness"), "<details class=\"agreement\" open>"));
}

BOOST_AUTO_TEST_CASE(a_fault_is_the_verdict_and_the_files_are_written_all_the_same) {
  const auto folder = std::filesystem::temp_directory_path() /
                      ("vcrit_test_extremes_page_" + std::to_string(::getpid()));
  const auto watch = [](const Standing&) {};
  const auto passed_of = [&] {
    return record::read_json(read_file(folder / "report.json"))["passed"] == true;
  };
  BOOST_TEST(report_extremes(honest_contents(), {{}, folder, {}}, watch).passed);
  BOOST_TEST(passed_of());
  const Validation validation = report_extremes(faulty_contents(), {{}, folder, {}}, watch);
  BOOST_TEST(!validation.passed);
  BOOST_TEST(!passed_of());
  BOOST_REQUIRE(validation.failed.size() == 2u);  // resonance and antiresonance have 31 cells
  BOOST_TEST(has(validation.failed.front(), "resonance: generated, certified within its bound"));
  BOOST_TEST(std::filesystem::exists(validation.page));
  std::filesystem::remove_all(folder);
}

BOOST_AUTO_TEST_CASE(without_a_compiler_generated_code_is_not_run) {
  const auto scene = symbolic::derive(problem_of(example::family("elastic")));
  const auto result = example::elastic(extremes::subjects_of(scene, std::nullopt));
  const auto folder = std::filesystem::temp_directory_path() /
                      ("vcrit_test_extremes_bare_" + std::to_string(::getpid()));
  const Validation validation = report_extremes({example::origin(), {"", {result}}},
                                                {{}, folder, {}}, [](const Standing&) {});
  BOOST_TEST(validation.passed);
  BOOST_TEST(validation.not_run.size() == 5u);  // a region each
  std::filesystem::remove_all(folder);
}

BOOST_AUTO_TEST_CASE(the_json_has_the_losses) {
  const auto report = record::read_json(extremes_json(honest_contents()));
  BOOST_TEST(report["passed"] == true);
  const auto& all = report["extremes"];
  BOOST_TEST(all["families"].size() == 1u);
  BOOST_TEST(all["in_words"].size() == 5u);
  const auto& region = all["families"][0]["regions"][3];
  BOOST_TEST(region["key"] == "antiresonance");
  const auto& fast = region["evaluators"][1];
  BOOST_TEST(fast["way"] == "fast");
  BOOST_TEST(fast["uncertified"] == 6);
  BOOST_TEST(fast["worst_inputs"].size() == 3u);
  BOOST_TEST(fast["worst_inputs"][0]["inputs"].get<std::string>().starts_with("omega = 0x1."));
  BOOST_TEST(region["simulator"]["wrong"] == 0);
  const auto& map = all["figures"][0]["map"];
  BOOST_TEST(map["values"].size() == map["x"].size() * map["y"].size());
}

BOOST_AUTO_TEST_SUITE_END()
