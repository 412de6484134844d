#include "report/equations.hpp"

#include <fmt/core.h>

#include "report/html.hpp"

namespace vcrit::validation::report {

namespace {

// More would push the numbers out of sight.
constexpr std::size_t shown_limits = 8;

std::string limit_row(const LimitLine& line) {
  return fmt::format("<tr><th scope=\"row\">{}{}</th><td>{}{}</td></tr>\n", line.mathml_name,
                     numbered(line.equation), equation(velocity_sign, line.result.mathml),
                     definitions(line.definitions));
}

}  // namespace

// MathML comes from the symbolic part and is no text.
std::string equation(const std::string& left, const std::string& right, const char* relation) {
  return fmt::format("<div class=\"scroll equation\" tabindex=\"0\">{} <span>{}</span> {}</div>",
                     left, relation, right);
}

const char* const velocity_sign = "<math><msup><mi>v</mi><mo>*</mo></msup></math>";

std::string equation(const Equation& line) { return equation(line.left.mathml, line.right.mathml); }

std::string numbered(const std::string& number) {
  return number.empty() ? "" : fmt::format("<small>Eq. {}</small>", escape(number));
}

std::string definitions(const std::vector<Equation>& lines) {
  if (lines.empty()) return {};
  std::string rows;
  for (const Equation& line : lines) rows += equation(line);
  return "<p class=\"where\">with <math><mi>s</mi><mo>=</mo><mi>i</mi><mi>ω</mi></math> and</p>" +
         rows + "\n";
}

std::string limits_table(const std::vector<LimitLine>& lines) {
  if (lines.empty()) return {};
  std::string rows;
  for (const LimitLine& line : lines) rows += limit_row(line);
  const std::string table = "<table class=\"limits\"><tbody>\n" + rows + "</tbody></table>\n";
  if (lines.size() <= shown_limits) return "<h3>Limits</h3>\n" + table;
  return fmt::format("<h3>Limits</h3>\n<details><summary>{} limits</summary>\n{}</details>\n",
                     lines.size(), table);
}

std::string asymptotes_table(const std::vector<AsymptoteLine>& lines) {
  if (lines.empty()) return {};
  std::string rows;
  for (const AsymptoteLine& line : lines)
    rows += fmt::format(
        "<tr><th scope=\"row\"><math><mi>ω</mi><mo>→</mo>{}</math></th><td>{}{}</td></tr>\n",
        line.low ? "<mn>0</mn>" : "<mi>∞</mi>", equation(velocity_sign, line.formula.mathml, "∼"),
        definitions(line.definitions));
  return "<table class=\"limits\"><tbody>\n" + rows + "</tbody></table>\n";
}

}  // namespace vcrit::validation::report
