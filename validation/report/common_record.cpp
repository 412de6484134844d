// What all reports share: comparisons, formulas, figures, the machine (records.hpp).
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "compare/velocity_comparisons.hpp"
#include "figures/figure_json.hpp"
#include "figures/svg.hpp"
#include "record/json_text.hpp"
#include "report/claims.hpp"
#include "report/html.hpp"
#include "report/records.hpp"
#include "report/units.hpp"
#include "report/verdict.hpp"

namespace vcrit::record {

namespace figures = validation::figures;
using validation::Comparison;

namespace {

/// "0.5 %"
std::string share_words(double share) {
  if (share > 0 && share < 1e-3) return "less than 0.1 %";
  return fmt::format("{:.2g} %", 100 * share);
}

/// The name of an outcome as a class of the style sheet.
std::string badge(Comparison::Outcome outcome) {
  std::string style = to_text(outcome);
  std::replace(style.begin(), style.end(), ' ', '-');
  return style;
}

}  // namespace

void fields(Fields& f, const Comparison& it) {
  const bool numbers = !it.not_run && !it.broken;
  const bool relative = it.measure == Comparison::Measure::relative;
  const auto result = outcome(it);
  f("key", it.key)("name", it.name)("reference", it.reference)("outcome", result);
  f.when(numbers, "unit", it.unit).when(numbers, "expected", it.expected);
  f.when(numbers, "found", it.found).when(numbers, "measure", relative ? "relative" : "absolute");
  f.when(numbers, "difference", difference(it)).when(numbers, "tolerance", it.tolerance);
  f.when(numbers, "tolerance_reason", it.reason).some("detail", it.detail);
  const bool agrees =
      result == Comparison::Outcome::passed && it.reference == validation::formula_reference;
  const validation::report::ComparisonWords claim = validation::report::claim_of(it);
  f.page("has_numbers", numbers).page("badge", badge(result)).page("ways_agree", agrees);
  f.page("claim", claim.words).page("means", claim.means).page("shared", claim.shared);
  const bool share = numbers && it.tolerance > 0 && std::isfinite(difference(it));
  f.page("share", share ? share_words(difference(it) / it.tolerance) : "");
}

void fields(Fields& f, const validation::ShownFormula& it) {
  f("text", it.text)("latex", it.latex).page("mathml", Markup{it.mathml});
}

void fields(Fields& f, const validation::ShownEquation& it) {
  f("left", it.left)("right", it.right).some("words", it.words);
  f.page("typeset_words", Markup{it.markup});
}

void fields(Fields& f, const validation::ShownVelocity& it) {
  f("formula", it.formula)("definitions", it.definitions)("real", it.is_real);
  f.page("ratio", present_markup(it.ratio_markup));
}

void fields(Fields& f, const validation::ShownFact& it) {
  f("key", it.key)("words", it.words)("lines", it.lines).page("shown_words", Markup{it.markup});
}

void fields(Fields& f, const validation::LimitLine& it) {
  f("name", it.name)("equation", it.equation)("result", it.result)("definitions", it.definitions);
  f.page("sign", Markup{it.mathml_name});
}

void fields(Fields& f, const figures::FigureSeries& it) {
  std::vector<std::pair<double, double>> points;
  for (const figures::Point& point : it.points) points.emplace_back(point.x, point.y);
  f("name", it.name)("style", name_of(it.style))("points", points);
}

void fields(Fields& f, const figures::Map& it) {
  f("value", it.value.title)("x", it.x)("y", it.y)("values", it.values);
}

namespace {

/// So that it can stand in the page without a script, too.
bool is_line_drawing(const figures::Figure& figure) {
  return !figure.map &&
         std::none_of(figure.series.begin(), figure.series.end(),
                      [](const auto& it) { return it.style == figures::Style::bars; });
}

}  // namespace

/// On a page a figure is what charts.js draws, at a picture's digits.
void fields(Fields& f, const figures::Figure& it) {
  f("name", it.name)("title", it.title);
  if (f.for_page()) {
    f("caption", validation::report::unbroken(it.caption));
    f("drawing", Markup{validation::report::json_for_page(figure_json(it))});
    f.when(is_line_drawing(it), "still", Markup{is_line_drawing(it) ? figures::still(it) : ""});
    return;
  }
  f("x", it.x.title)("y", it.y.title)("series", it.series).some("map", it.map);
}

void fields(Fields& f, const validation::Machine& it) {
  Fields versions(Reader::file);
  for (const auto& [name, version] : it.versions) versions(name.c_str(), version);
  f("processor", it.processor)("cores", it.cores)("system", it.system)("commit", it.commit);
  f("compiler_flags", it.compiler_flags)("versions", versions.take());
  Json parts = Json::array();
  for (const auto& [name, version] : it.versions)
    parts.push_back({{"name", name}, {"version", version}});
  f.page("parts", parts);
}

}  // namespace vcrit::record

namespace vcrit::validation::report {

record::Json report_head(const Origin& origin, bool passed) {
  return {{"program", "vcrit"},
          {"version", origin.machine.program},
          {"passed", passed},
          {"command", origin.command},
          {"machine", record::json_of(origin.machine)}};
}

void add_origin(const Origin& origin, record::Json& page) {
  page["version"] = origin.machine.program;
  page["command"] = origin.command;
  page["machine"] = record::page_of(origin.machine);
}

void add_comparisons(record::Fields& f, const std::vector<Comparison>& comparisons) {
  f("comparisons", comparisons);
  f.page("count_words", count_words(comparisons));
  f.page("all_passed", count(comparisons, Comparison::Outcome::failed) == 0);
}

void add_verdict(const std::vector<Comparison>& comparisons, record::Json& page) {
  const bool failed = count(comparisons, Comparison::Outcome::failed) > 0;
  page["formula_applies"] = true;
  page["verdict"] = {{"state", failed ? "failed" : "passed"},
                     {"words", count_words(comparisons)},
                     {"tightest", tightest_words(comparisons)}};
}

std::string text_of(const record::Json& report) { return record::json_text(report, 1) + "\n"; }

}  // namespace vcrit::validation::report
