#include "report/comparison_table.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "base/numbers.hpp"
#include "report/html.hpp"
#include "report/units.hpp"
#include "velocity_comparisons.hpp"

namespace vcrit::validation::report {

namespace {

std::string with_unit(double value, const std::string& unit) {
  const std::string text = vcrit::to_text(value);
  return unit.empty() ? text : text + " " + unit;
}

/// The name of an outcome as a class of the style sheet.
std::string outcome_style(Comparison::Outcome outcome) {
  std::string style = to_text(outcome);
  std::replace(style.begin(), style.end(), ' ', '-');
  return style;
}

std::string cell(const char* heading, const std::string& content, const char* style = "") {
  return fmt::format("<td data-label=\"{}\" class=\"{}\">{}</td>", heading, style, content);
}

std::string outcome_cell(const Comparison& comparison, bool applies) {
  const auto result = outcome(comparison);
  const bool no_more = result == Comparison::Outcome::passed && !applies;
  return fmt::format("<td class=\"outcome\"><span class=\"badge {}\">{}</span></td>",
                     no_more ? "outside" : outcome_style(result),
                     no_more ? "agrees" : validation::to_text(result));
}

std::string name_cell(const Comparison& comparison) {
  return fmt::format("<th scope=\"row\">{}<small>against {}</small></th>", escape(comparison.name),
                     escape(comparison.reference));
}

std::string without_numbers(const Comparison& comparison, bool applies) {
  return fmt::format("<tr>{}<td colspan=\"3\" class=\"detail\">{}</td>{}</tr>\n",
                     name_cell(comparison), escape(comparison.detail),
                     outcome_cell(comparison, applies));
}

std::string with_numbers(const Comparison& comparison, bool applies) {
  const char* kind = comparison.measure == Comparison::Measure::relative ? "relative" : "absolute";
  const std::string value =
      fmt::format("{}<small>{}</small>", escape(with_unit(comparison.found, comparison.unit)),
                  escape(with_unit(comparison.expected, comparison.unit)));
  const std::string apart =
      fmt::format("{}<small>{}{}</small>", magnitude(difference(comparison)), kind,
                  comparison.detail.empty() ? "" : ", " + escape(comparison.detail));
  const std::string allowed =
      fmt::format("{}<small class=\"reason\">{}</small>", magnitude(comparison.tolerance),
                  escape(comparison.reason));
  return fmt::format("<tr>{}{}{}{}{}</tr>\n", name_cell(comparison),
                     cell("Value, reference", value, "figures"), cell("Difference", apart),
                     cell("Allowed", allowed), outcome_cell(comparison, applies));
}

}  // namespace

std::string comparison_table(const std::vector<Comparison>& comparisons, bool formula_applies) {
  std::string rows;
  for (const Comparison& comparison : comparisons) {
    const bool applies = formula_applies || comparison.reference != formula_reference;
    rows += comparison.not_run || comparison.broken ? without_numbers(comparison, applies)
                                                    : with_numbers(comparison, applies);
  }
  return "<table class=\"comparisons\"><thead><tr><th>What</th>"
         "<th>Value<small>reference</small></th><th>Difference</th><th>Allowed</th><th></th></tr>"
         "</thead><tbody>\n" +
         rows + "</tbody></table>\n";
}

std::string count_words(const std::vector<Comparison>& comparisons) {
  const auto failures = count(comparisons, Comparison::Outcome::failed);
  const auto skipped = count(comparisons, Comparison::Outcome::not_run);
  const auto made = comparisons.size() - skipped;
  std::string words = failures > 0 ? fmt::format("{} of {} comparisons failed", failures, made)
                                   : fmt::format("{} comparisons passed", made);
  if (skipped > 0) words += fmt::format(", {} not run", skipped);
  return words;
}

std::string tightest_words(const std::vector<Comparison>& comparisons) {
  const Comparison* worst = tightest(comparisons);
  if (worst == nullptr) return {};
  if (worst->broken) return fmt::format("{}: {}", worst->name, worst->detail);
  return fmt::format("Nearest to its tolerance: {}, {} of {} allowed.", worst->name,
                     magnitude(difference(*worst)), magnitude(worst->tolerance));
}

}  // namespace vcrit::validation::report
