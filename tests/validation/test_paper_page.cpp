// The page and the JSON file about the paper: every section is there, faults are red, and nothing
// comes from outside.
#include "report/paper_page.hpp"

#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "base/files.hpp"
#include "paper/paper.hpp"
#include "record/json_text.hpp"
#include "report/assets.hpp"
#include "report/validate.hpp"
#include "support/patterns.hpp"
#include "validation/example_report.hpp"

BOOST_AUTO_TEST_SUITE(test_paper_page)

using namespace vcrit::validation;
using namespace vcrit::validation::report;

namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

PaperContents contents() {
  static const paper::Paper paper = paper::go_through([](const std::string&) {});
  return {{example::origin().machine, paper_command}, paper};
}

/// Without scripts and style.
std::string page_of(const PaperContents& what) {
  std::string html = paper_page(what);
  for (const std::string_view script : scripts()) {
    const auto at = html.find(script);
    BOOST_REQUIRE(at != html.npos);
    html.erase(at, script.size());
  }
  const auto style_at = html.find(style());
  BOOST_REQUIRE(style_at != html.npos);
  return html.erase(style_at, style().size());
}

std::string section_of(const std::string& html, const std::string& id) {
  const auto begin = html.find("<section class=\"scene\" id=\"" + id + "\">");
  BOOST_REQUIRE(begin != html.npos);
  return html.substr(begin, html.find("</section>", begin) - begin);
}

const std::vector<std::string> sections{"equations",  "range",     "figure4",   "difference",
                                        "amplitudes", "slow",      "viscosity", "flat-punch",
                                        "shapes",     "misprints", "claims"};

}  // namespace

BOOST_AUTO_TEST_CASE(the_sections_are_there_in_order) {
  const std::string html = page_of(contents());
  std::size_t at = html.find("class=\"verdict passed\"");
  BOOST_REQUIRE(at != html.npos);
  for (const std::string& id : sections) {
    const auto next = html.find("id=\"" + id + "\"", at);
    BOOST_TEST_REQUIRE(next != html.npos, id);
    at = next;
    BOOST_TEST(has(section_of(html, id), "<table class=\"comparisons\">"), id);
  }
  BOOST_TEST(has(html, " comparisons passed"));
  BOOST_TEST(!has(html, "comparisons failed"));
  BOOST_TEST(has(html, "vcrit validate --paper --out report"));
}

BOOST_AUTO_TEST_CASE(each_section_has_its_content) {
  const std::string html = page_of(contents());
  const std::string equations = section_of(html, "equations"),
                    figure4 = section_of(html, "figure4");
  for (const char* number :
       {"Equation (27)", "Equation (29)", "Equation (30)", "Equation (31)", "<math"})
    BOOST_TEST(has(equations, number));
  for (const char letter : {'a', 'b', 'c', 'd'})
    for (const char* model : {"reduced", "full"})
      BOOST_TEST(has(figure4, std::string("id=\"figure4") + letter + "_" + model + "\""));
  BOOST_TEST(has(section_of(html, "difference"), "id=\"reduced_less_full\""));
  BOOST_TEST(has(section_of(html, "amplitudes"), "0.447213595499958"));  // 1/sqrt(5)
  BOOST_TEST(has(section_of(html, "flat-punch"), "0.201452203333669"));  // docs/physics.md
  const std::string claims = section_of(html, "claims");
  BOOST_TEST(has(claims, "0.434728238016"));  // docs/physics.md, delta = 10, 0.1
  BOOST_TEST(has(claims, "+0.285977"));       // the reduced model there, less that
  for (const char* verdict : {"holds", "in part", "fails", "not legible"})
    BOOST_TEST(has(claims, std::string(">") + verdict + "</span>"), verdict);
}

// Of the equations derived only (30) is legible in the source.
BOOST_AUTO_TEST_CASE(what_is_not_legible_is_not_as_printed) {
  const std::string html = page_of(contents()), equations = section_of(html, "equations");
  std::map<std::string, std::string> parts;
  for (const char* number : {"(27)", "(29)", "(30)", "(31)"}) {
    const auto begin = equations.find(std::string("<h3>Equation ") + number);
    BOOST_REQUIRE(begin != equations.npos);
    parts[number] = equations.substr(begin, equations.find("<h3>", begin + 1) - begin);
  }
  for (const auto& [number, part] : parts) {
    BOOST_TEST(has(part, "As printed") == (number == "(30)"), number);
    BOOST_TEST(has(part, "does not show it legibly") == (number != "(30)"), number);
  }
  BOOST_TEST(!has(section_of(html, "figure4"), "as printed"));
  BOOST_TEST(!has(html, "(29) as printed"));
}

// Sections about the rigidly driven contact, which has no mass.
BOOST_AUTO_TEST_CASE(no_mass_where_there_is_none) {
  const std::string html = vcrit::test::without_matches(page_of(contents()), "</?t?body>");
  for (const char* id : {"figure4", "difference", "amplitudes", "slow", "flat-punch"}) {
    const std::string section = section_of(html, id);
    BOOST_TEST(!has(section, "mass"), id);
    BOOST_TEST(!has(section, "body"), id);
  }
}

BOOST_AUTO_TEST_CASE(a_fault_is_red_and_open) {
  PaperContents faulty = contents();
  faulty.paper.amplitudes.comparisons.front().found += 1;
  faulty.paper.claims = judge(faulty.paper);
  const std::string html = page_of(faulty);
  BOOST_TEST(has(html, "class=\"verdict failed\""));
  BOOST_TEST(has(html, "1 of 153 comparisons failed"));
  BOOST_TEST(has(section_of(html, "amplitudes"), "<details class=\"agreement\" open>"));
  BOOST_TEST(!has(section_of(html, "slow"), "<details class=\"agreement\" open>"));
  BOOST_TEST(has(section_of(html, "claims"), "not shown"));
  BOOST_TEST(!passed(faulty.paper));
  BOOST_TEST(vcrit::record::read_json(paper_json(faulty))["passed"] == false);
}

BOOST_AUTO_TEST_CASE(a_fault_is_the_verdict_and_the_files_are_written_all_the_same) {
  const auto folder = std::filesystem::temp_directory_path() /
                      ("vcrit_test_paper_page_" + std::to_string(::getpid()));
  const auto watch = [](const Standing&) {};
  BOOST_TEST(report_paper(contents(), {{}, folder, {}}, watch).passed);
  PaperContents faulty = contents();
  faulty.paper.punch.comparisons.back().found = 1;
  const Validation validation = report_paper(faulty, {{}, folder, {}}, watch);
  BOOST_TEST(!validation.passed);
  BOOST_REQUIRE(validation.failed.size() == 1u);
  BOOST_TEST(has(validation.failed.front(), faulty.paper.punch.comparisons.back().name));
  BOOST_TEST(vcrit::record::read_json(vcrit::read_file(folder / "report.json"))["passed"] == false);
  BOOST_TEST(std::filesystem::exists(validation.page));
  std::filesystem::remove_all(folder);
}

BOOST_AUTO_TEST_CASE(an_equation_that_is_not_equal_is_told_so) {
  PaperContents faulty = contents();
  faulty.paper.proofs.comparisons.front().broken = true;
  const std::string section = section_of(page_of(faulty), "equations");
  BOOST_TEST(has(section, "badge failed\">not equal"));
  BOOST_TEST(!has(section_of(page_of(contents()), "equations"), "not equal"));
}

BOOST_AUTO_TEST_CASE(nothing_is_loaded_from_outside) {
  // The name of MathML's namespace is no address.
  const std::string html =
      vcrit::test::without_matches(page_of(contents()), "http://www.w3.org/1998/Math/MathML");
  for (const char* outward : {"http:", "https:", " src=", "<link"}) BOOST_TEST(!has(html, outward));
  BOOST_TEST(!vcrit::test::has_match(html, "href=\"(?!#)"));
  BOOST_TEST(has(html, "default-src 'none'"));
}

BOOST_AUTO_TEST_CASE(the_json_has_all_data) {
  const auto report = vcrit::record::read_json(paper_json(contents()));
  BOOST_TEST(report["passed"] == true);
  const auto& paper = report["paper"];
  std::size_t comparisons = 0;
  for (const char* part :
       {"equations", "range", "figure4", "difference", "jump_limits", "static_limit", "viscosity",
        "flat_punch", "shapes", "misprints", "evidence"})
    comparisons += paper.at(part).at("comparisons").size();
  BOOST_TEST(comparisons == all_comparisons(contents().paper).size());
  BOOST_TEST(paper["figure4"]["full"].size() == 4u);
  BOOST_TEST(paper["claims"].size() == 17u);
  const auto& map = paper["difference"]["figure"]["map"];
  BOOST_TEST(map["values"].size() == map["x"].size() * map["y"].size());
  BOOST_TEST(paper["evidence"]["rows"][0]["reference"] == 0.3975961226668819235);
}

BOOST_AUTO_TEST_SUITE_END()
