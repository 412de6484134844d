#include "report/accuracy_section.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "accuracy/pictures.hpp"
#include "report/chart.hpp"
#include "report/html.hpp"
#include "report/units.hpp"

namespace vcrit::validation::report {

namespace {

using accuracy::Accuracy;
using accuracy::EvaluatorError;
using accuracy::EvaluatorErrors;
using accuracy::Layer;
using accuracy::Solve;
using accuracy::SpeedSolves;
using accuracy::StabilityMap;
using accuracy::WorstInput;

std::string table(const std::string& head, const std::string& rows) {
  return fmt::format(
      "<div class=\"scroll\" tabindex=\"0\"><table class=\"numbers\"><thead><tr>{}</tr></thead>"
      "<tbody>\n{}</tbody></table></div>\n",
      head, rows);
}

std::string heads(const std::vector<const char*>& words) {
  std::string html;
  for (const char* word : words) html += fmt::format("<th scope=\"col\">{}</th>", word);
  return html;
}

std::string details(const std::string& summary, const std::string& content) {
  return fmt::format("<details class=\"data\"><summary>{}</summary>{}</details>\n", summary,
                     content);
}

std::string way_row(const EvaluatorError& way) {
  return fmt::format(
      "<tr><th scope=\"row\">{}</th><td>{:.3g} "
      "ns</td><td>{:.3g}</td><td>{:.3g}</td><td>{}</td></tr>\n",
      escape(way.name), way.nanoseconds, way.worst, way.rms,
      !way.failure.empty() ? "failed"
      : way.on_front       ? "on the front"
                           : "");
}

std::string ways(const EvaluatorErrors& errors) {
  std::string rows;
  for (const EvaluatorError& way : errors.ways)
    if (way.measured) rows += way_row(way);
  return table(heads({"evaluator", "a value", "worst error, ulp", "root mean square, ulp", ""}),
               rows);
}

/// More would make the page twice as long for a hundred branches.
constexpr std::size_t most_parameters = 32;

std::string parameters(const WorstInput& input, const std::vector<Symbol>& symbols) {
  std::string text;
  for (std::size_t i = 0; i < std::min(symbols.size(), most_parameters); ++i)
    text += fmt::format("{}{} = {:a}", i == 0 ? "" : ", ", to_text(symbols[i]), input.set[i]);
  return symbols.size() > most_parameters ? text + ", … (all in report.json)" : text;
}

std::string worst_inputs(const EvaluatorErrors& errors) {
  std::string rows;
  for (const EvaluatorError& way : errors.ways)
    for (const WorstInput& input : way.worst_inputs)
      rows += fmt::format(
          "<tr><td>{}</td><td>{:.3g}</td><td><code>{:a}</code></td><td><code>{:a}</code></td>"
          "<td><code>{}</code></td></tr>\n",
          escape(way.name), input.error, input.found, input.right,
          escape(parameters(input, errors.symbols)));
  if (rows.empty()) return "<p>Every value is correctly rounded.</p>\n";
  return details("The worst inputs of each evaluator, at most ten",
                 table(heads({"evaluator", "error, ulp", "found", "right", "at"}), rows));
}

std::string failure_row(const std::string& what, const std::string& why) {
  return fmt::format("<tr><th scope=\"row\">{}</th><td class=\"reason\">{}</td></tr>\n",
                     escape(what), escape(why));
}

std::string failures(const std::string& rows) {
  if (rows.empty()) return {};
  return fmt::format(
      "<p>Not ranked:</p>\n<div class=\"scroll\" tabindex=\"0\"><table><tbody>\n{}</tbody></table>"
      "</div>\n",
      rows);
}

std::string failed_ways(const EvaluatorErrors& errors) {
  std::string rows;
  for (const EvaluatorError& way : errors.ways)
    if (!way.failure.empty()) rows += failure_row(way.name, way.failure);
  return failures(rows);
}

std::string evaluators(const EvaluatorErrors& errors) {
  const std::string compiler =
      errors.compiler.empty() ? "" : fmt::format(", compiled by {}", escape(errors.compiler));
  return fmt::format(
             "<h3>Evaluators: error against run time</h3>\n<p>{} parameter sets around the scene "
             "(seed {}){}. Reference: the correctly rounded value. An evaluator that gives a value "
             "that is not finite, or one that is off by more than 10⁻¹⁰ and by more than the "
             "condition number explains, is not ranked.</p>\n",
             errors.sets, errors.seed, compiler) +
         panels({evaluator_picture(errors), histogram_picture(errors)}) + ways(errors) +
         failed_ways(errors) + worst_inputs(errors);
}

std::string failed_solves(const std::vector<SpeedSolves>& speeds) {
  std::string rows;
  for (const SpeedSolves& speed : speeds)
    for (const Solve& solve : speed.solves)
      if (!solve.failure.empty())
        rows += failure_row(fmt::format("{} {} at {}", solve.method, solve.setting, speed.ratio),
                            solve.failure);
  return failures(rows);
}

std::string solve_rows(const std::vector<SpeedSolves>& speeds) {
  std::string rows;
  for (const SpeedSolves& speed : speeds)
    for (const Solve& solve : speed.solves)
      if (solve.answered)
        rows += fmt::format(
            "<tr><td>{}</td><td>{} {}</td><td>{:.3g} µs</td><td>{}</td><td>{}</td></tr>\n",
            speed.ratio, escape(solve.method), escape(solve.setting), 1e6 * solve.seconds,
            magnitude(solve.error),
            !solve.failure.empty() ? "failed"
            : solve.on_front       ? "on the front"
                                   : "");
  return rows;
}

std::string simulators(const std::vector<SpeedSolves>& speeds) {
  if (speeds.empty()) return {};
  std::vector<figures::Figure> figures;
  for (const SpeedSolves& speed : speeds) figures.push_back(simulator_picture(speed));
  return "<h3>Simulators: error against run time</h3>\n" + panels(figures) + failed_solves(speeds) +
         details("The numbers",
                 table(heads({"speed", "method", "time", "error", ""}), solve_rows(speeds)));
}

std::string map_heading(const StabilityMap& map) {
  return map.key == "stiffness" ? "Stability over stiffness ratio and frequency"
                                : "Stability over relaxation time and frequency";
}

std::string maps(const std::vector<StabilityMap>& all) {
  std::string html;
  for (const StabilityMap& map : all) {
    std::vector<figures::Figure> figures;
    for (const Layer& layer : map.layers) figures.push_back(map_picture(map, layer));
    html += fmt::format("<h3>{}</h3>\n", map_heading(map)) + panels(figures);
  }
  return html;
}

std::string left_out(const std::vector<std::string>& sentences) {
  std::string html;
  for (const std::string& sentence : sentences) html += "<p>" + escape(sentence) + "</p>\n";
  return html;
}

}  // namespace

std::string accuracy_section(const Accuracy& accuracy) {
  return "<section class=\"accuracy\" aria-label=\"Accuracy, cost and stability\">\n" +
         evaluators(accuracy.evaluators) + simulators(accuracy.simulators) + maps(accuracy.maps) +
         left_out(accuracy.left_out) +
         fmt::format("<p>Measured again by <code>{}</code>.</p>\n</section>\n",
                     escape(accuracy.command));
}

}  // namespace vcrit::validation::report
