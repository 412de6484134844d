#include "report/equations.hpp"

#include <fmt/format.h>

#include "report/html.hpp"

namespace vcrit::validation::report {

namespace {

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

// More would push the numbers out of sight.
constexpr std::size_t shown_limits = 8;

std::string limit(const LimitLine& line) {
  return fmt::format("<tr><th scope=\"row\">{}{}</th><td>{}{}</td></tr>\n", set_limit(line.name),
                     numbered(line.equation), equation(velocity, line.result.mathml),
                     definitions(line.definitions));
}

}  // namespace

// MathML comes from the symbolic part and is no text.
std::string equation(const std::string& left, const std::string& right) {
  return fmt::format("<div class=\"scroll equation\" tabindex=\"0\">{} <span>=</span> {}</div>",
                     left, right);
}

const char* const velocity = "<math><msup><mi>v</mi><mo>*</mo></msup></math>";

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
  for (const LimitLine& line : lines) rows += limit(line);
  const std::string table = "<table class=\"limits\"><tbody>\n" + rows + "</tbody></table>\n";
  if (lines.size() <= shown_limits) return "<h3>Limits</h3>\n" + table;
  return fmt::format("<h3>Limits</h3>\n<details><summary>{} limits</summary>\n{}</details>\n",
                     lines.size(), table);
}

}  // namespace vcrit::validation::report
