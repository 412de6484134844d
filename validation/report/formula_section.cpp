#include "report/formula_section.hpp"

#include <fmt/core.h>

#include "report/equations.hpp"
#include "report/html.hpp"
#include "report/units.hpp"

namespace vcrit::validation::report {

namespace {

std::string copyable(const std::string& latex) {
  return fmt::format(
      "<details class=\"latex\"><summary>LaTeX</summary><button type=\"button\" class=\"copy\">Copy"
      "</button><pre tabindex=\"0\"><code>{}</code></pre></details>\n",
      escape(latex));
}

std::string latex_of(const SceneReport& report) {
  std::string text = "v^* = " + report.formula.latex;
  for (const Equation& line : report.definitions)
    text += "\n" + line.left.latex + " = " + line.right.latex;
  return text;
}

/// The derivation's words with the signs that a page has.
std::string set_words(std::string words) {
  constexpr std::pair<const char*, const char*> signs[] = {{"i*omega", "iω"},
                                                           {"|omega B|", "|ωB|"},
                                                           {"K_t/K_n", "Kₜ/Kₙ"},
                                                           {" - nu", " − ν"},
                                                           {"v0 -", "v₀ −"}};
  for (const auto& [from, to] : signs)
    for (auto at = words.find(from); at != words.npos; at = words.find(from))
      words.replace(at, std::string(from).size(), to);
  return escape(words);
}

std::string derivation(const SceneReport& report) {
  if (report.derivation.empty()) return {};
  std::string steps;
  for (const Equation& line : report.derivation)
    steps += fmt::format("<li><p>{}</p>{}</li>\n", set_words(line.words), equation(line));
  return "<details class=\"derivation\" open><summary>Derivation</summary><ol>\n" + steps +
         "</ol></details>\n";
}

}  // namespace

std::string formula_section(const SceneReport& report) {
  if (report.formula.mathml.empty()) return {};
  return "<h3>The formula</h3>\n" + numbered(report.equation) +
         equation(velocity_sign, report.formula.mathml) + definitions(report.definitions) +
         copyable(latex_of(report)) + derivation(report) + limits_table(report.limits);
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
