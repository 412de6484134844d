#include "report/formula_section.hpp"

#include <fmt/format.h>

#include "report/html.hpp"
#include "report/units.hpp"

namespace vcrit::validation::report {

namespace {

/// The two sides of an equation as one line; MathML comes from the symbolic part and is no text.
std::string equation(const std::string& left, const std::string& right) {
  return fmt::format("<div class=\"scroll equation\" tabindex=\"0\">{} <span>=</span> {}</div>",
                     left, right);
}

const char* const velocity = "<math><msup><mi>v</mi><mo>*</mo></msup></math>";

std::string copyable(const std::string& latex) {
  return fmt::format(
      "<details class=\"latex\"><summary>LaTeX</summary><button type=\"button\" class=\"copy\">Copy"
      "</button><pre tabindex=\"0\"><code>{}</code></pre></details>\n",
      escape(latex));
}

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

std::string latex_of(const SceneReport& report) {
  std::string text = "v^* = " + report.formula.latex;
  for (const Equation& line : report.definitions)
    text += "\n" + line.left.latex + " = " + line.right.latex;
  return text;
}

std::string derivation(const SceneReport& report) {
  if (report.derivation.empty()) return {};
  std::string steps;
  for (const Equation& line : report.derivation)
    steps += fmt::format("<li><p>{}</p>{}</li>\n", escape(line.words), equation(line));
  return "<details class=\"derivation\" open><summary>Derivation</summary><ol>\n" + steps +
         "</ol></details>\n";
}

/// "kd -> infinity" with the characters that a page has for it.
std::string set_limit(std::string name) {
  const auto replace = [&](const std::string& from, const std::string& to) {
    for (auto at = name.find(from); at != name.npos; at = name.find(from, at + to.size()))
      name.replace(at, from.size(), to);
  };
  replace("->", "→");
  replace("infinity", "∞");
  return escape(name);
}

std::string limit(const LimitLine& line) {
  return fmt::format("<tr><th scope=\"row\">{}{}</th><td>{}{}</td></tr>\n", set_limit(line.name),
                     numbered(line.equation), equation(velocity, line.result.mathml),
                     definitions(line.definitions));
}

// More would push the numbers out of sight.
constexpr std::size_t shown_limits = 8;

std::string limits(const SceneReport& report) {
  if (report.limits.empty()) return {};
  std::string rows;
  for (const LimitLine& line : report.limits) rows += limit(line);
  const std::string table = "<table class=\"limits\"><tbody>\n" + rows + "</tbody></table>\n";
  const std::size_t count = report.limits.size();
  if (count <= shown_limits) return "<h3>Limits</h3>\n" + table;
  return fmt::format("<h3>Limits</h3>\n<details><summary>{} limits</summary>\n{}</details>\n",
                     count, table);
}

}  // namespace

std::string formula_section(const SceneReport& report) {
  if (report.formula.mathml.empty()) return {};
  return "<h3>The formula</h3>\n" + numbered(report.equation) +
         equation(velocity, report.formula.mathml) + definitions(report.definitions) +
         copyable(latex_of(report)) + derivation(report) + limits(report);
}

std::string values_section(const SceneReport& report) {
  if (report.values.empty()) return {};
  std::string rows;
  for (const ValueLine& line : report.values)
    rows += fmt::format(
        "<tr><th scope=\"row\">{}</th><td class=\"figures\">{}</td><td>{}</td></tr>\n",
        line.name.mathml, escape(quantity(line.value, line.unit)), escape(line.meaning));
  return "<h3>Values</h3>\n<table class=\"plain values\"><tbody>\n" + rows + "</tbody></table>\n";
}

}  // namespace vcrit::validation::report
