#include "report/reduced_section.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace vcrit::validation::report {

namespace {

std::string head(const ReducedTable& table) {
  std::string cells;
  for (const double ratio : table.ratios) cells += fmt::format("<th scope=\"col\">{}</th>", ratio);
  return fmt::format("<thead><tr><th scope=\"col\">δ, v₀/v*</th>{}</tr></thead>", cells);
}

// "+0.2871"; what would be printed as zero has no sign.
std::string shown(double difference) {
  const std::string text = fmt::format("{:+.3f}", difference);
  return text.find_first_not_of("+-0.") == text.npos ? "0" : text;
}

// The wash is darkest from 0.3 on.
std::string heat_cell(double difference) {
  return fmt::format("<td style=\"--heat: {:.0f}%\">{}</td>",
                     100 * std::min(std::abs(difference) / 0.3, 1.0), shown(difference));
}

std::string heat_row(const ReducedModel& model, std::size_t number) {
  const double delta = model.table.deltas[number];
  const bool own = delta == model.delta;
  std::string cells;
  for (const ReducedAndFull& pair : model.table.rows[number]) cells += heat_cell(pair.difference());
  return fmt::format("<tr{}><th scope=\"row\">{:.3g}{}</th>{}</tr>\n", own ? " class=\"own\"" : "",
                     delta, own ? "<small>this scene</small>" : "", cells);
}

std::string advice(const ReducedModel& model) {
  if (!model.usable_from)
    return fmt::format(
        "Here, at δ = {:.3g}, it is not to be used: it is off by more than {} right up "
        "to v*.",
        model.delta, model.tolerance);
  if (*model.usable_from < 0.015)
    return fmt::format(
        "Here, at δ = {:.3g}, it may be used at any speed: it is off by less than {}.", model.delta,
        model.tolerance);
  return fmt::format(
      "Here, at δ = {:.3g}, it may be used from v₀ = {} v* on, where it is off by less "
      "than {}; below that it is not to be used.",
      model.delta, *model.usable_from, model.tolerance);
}

}  // namespace

std::string reduced_section(const SceneReport& report) {
  if (!report.reduced_model) return {};
  const ReducedModel& model = *report.reduced_model;
  std::string rows;
  for (std::size_t i = 0; i < model.table.deltas.size(); ++i) rows += heat_row(model, i);
  return fmt::format(
      "<h3>The reduced model</h3>\n<p>The paper’s (47)–(51) leave out what the damper still "
      "relaxes after each stick. {}</p>\n<figure><div class=\"scroll\" tabindex=\"0\">"
      "<table class=\"heat\">{}<tbody>\n{}</tbody></table></div><figcaption>Friction ratio by the "
      "reduced model less that of the full motion, over δ = ω c/k and v₀/v*; 0 is below 0.0005. At "
      "this scene’s normal force, mean × (1 ± {:.3g}), to which the difference is "
      "proportional.</figcaption></figure>\n",
      advice(model), head(model.table), rows, model.table.a);
}

}  // namespace vcrit::validation::report
