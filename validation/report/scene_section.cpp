#include "report/scene_section.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <cmath>

#include "base/constants.hpp"
#include "report/accuracy_section.hpp"
#include "report/chart.hpp"
#include "report/comparison_table.hpp"
#include "report/equations.hpp"
#include "report/explorer_section.hpp"
#include "report/formula_section.hpp"
#include "report/html.hpp"
#include "report/indenter_section.hpp"
#include "report/parting_section.hpp"
#include "report/reduced_section.hpp"
#include "report/scene_figures.hpp"
#include "report/system_drawing.hpp"
#include "report/units.hpp"

namespace vcrit::validation::report {

namespace {

bool was_simulated(const SceneReport& report) { return !report.curve.empty(); }

std::string item_list(const std::vector<std::string>& items, const char* style) {
  std::string lines;
  for (const std::string& item : items) lines += "<li>" + escape(item) + "</li>\n";
  return fmt::format("<ul class=\"{}\">\n{}</ul>\n", style, lines);
}

std::string scene_verdict(const SceneReport& report) {
  const bool outside = !report.reasons.empty();
  std::string html = fmt::format(
      "<div class=\"verdict {}\"><p class=\"state\">{}</p><p class=\"velocity\">{}</p>"
      "<p class=\"worst\">{}</p></div>\n",
      state_class(report), escape(state_words(report)), escape(velocity_words(report)),
      outside ? "" : escape(tightest_words(report.comparisons)));
  if (outside)
    html +=
        "<p>Equation (24) does not describe this motion, so there is no v* here and nothing was "
        "simulated:</p>\n" +
        item_list(report.reasons, "reasons");
  if (const std::vector<int>& free = report.free_harmonics; !free.empty())
    html += fmt::format(
        "<p>The undamped drive lets the body swing freely at {} ω, and the motion keeps such {}: "
        "friction is full from {} on{}.</p>\n",
        fmt::join(free, " ω, "), free.size() > 1 ? "swings" : "a swing",
        quantity(report.sliding_from, "m/s", 5),
        free.size() > 1 ? "" : fmt::format(", v* cos(π/{})", 2 * free.front()));
  if (!report.infinite_reason.empty()) html += "<p>" + escape(report.infinite_reason) + "</p>\n";
  if (!report.scene.warnings.empty()) html += item_list(report.scene.warnings, "warnings");
  return html;
}

std::string figure(const std::string& svg, const std::string& caption) {
  return fmt::format(
      "<figure><div class=\"scroll\" tabindex=\"0\">{}</div><figcaption>{}</figcaption></figure>\n",
      svg, caption);
}

std::string drawings(const SceneReport& report) {
  return "<h3>What is there</h3>\n<div class=\"drawings\">\n" +
         figure(draw_sliding(report.scene), "Along the sliding direction.") +
         figure(draw_normal(report.scene), "Along the normal, drawn lying.") + "</div>\n";
}

/// Outside the model it is no good news that all ways to evaluate the formula agree.
std::string comparisons_section(const SceneReport& report) {
  const bool outside = !report.reasons.empty();
  const std::string table =
      comparison_table(report.comparisons, report.formula_applies && !outside);
  if (report.formula_applies && !outside) return table;
  if (!outside)
    return "<p>Equation (24) is not v* of this scene. Where ways to evaluate it agree, that is "
           "arithmetic alone.</p>\n" +
           table;
  return "<p>What can be compared is arithmetic alone: the formula, evaluated in several ways. Its "
         "number has no meaning for this scene.</p>\n" +
         table;
}

std::string curve_rows(const SceneReport& report) {
  std::string rows;
  for (const CurvePoint& point : report.curve)
    rows += fmt::format(
        "<tr><td>{:.4g}</td><td>{}</td><td>{:.12f}</td><td>{:.12f}</td><td>{}</td></tr>\n",
        point.ratio, quantity(point.velocity, "m/s"), point.from_sliding, point.from_rest,
        escape(point.regime));
  return rows;
}

std::string curve_table(const SceneReport& report) {
  return fmt::format(
      "<details class=\"data\"><summary>The numbers</summary><div class=\"scroll\" tabindex=\"0\">"
      "<table class=\"numbers\"><thead><tr><th>{}</th><th>v₀</th><th>from sliding</th>"
      "<th>from rest</th><th>motion</th></tr></thead><tbody>\n{}</tbody></table></div></details>\n",
      speed_axis(report), curve_rows(report));
}

/// A method's first reason stands for all.
std::string missing_answers(const SceneReport& report) {
  std::vector<std::string> lines;
  for (const MethodCurve& method : report.methods) {
    std::string at, reason;
    for (const MethodPoint& point : method.points) {
      if (point.reason.empty()) continue;
      at += fmt::format("{}{}", at.empty() ? "" : ", ", point.ratio);
      if (reason.empty()) reason = point.reason;
    }
    if (!at.empty()) lines.push_back(fmt::format("{} at {}: {}", method.method, at, reason));
  }
  return lines.empty() ? "" : "<p>Without an answer:</p>\n" + item_list(lines, "reasons");
}

std::string response_section(const SceneReport& report) {
  if (report.response.points.empty()) return {};
  return "<h3>Frequency response</h3>\n" + chart(velocity_response_figure(report)) +
         asymptotes_table(report.response.asymptotes) + chart(stiffness_figure(report));
}

std::string friction_section(const SceneReport& report) {
  if (!was_simulated(report)) return {};
  std::string html = "<h3>Friction against speed</h3>\n" + chart(friction_figure(report));
  if (!report.methods.empty()) html += chart(residual_figure(report));
  return html + curve_table(report) + missing_answers(report);
}

std::string cycle_section(const SceneReport& report) {
  if (!report.cycle) return {};
  return "<h3>One cycle</h3>\n" + chart(force_figure(report)) + chart(velocity_figure(report));
}

std::string file_section(const SceneReport& report) {
  return fmt::format(
      "<h3>The scene file</h3>\n<p class=\"file\"><code>{}</code></p>\n"
      "<pre class=\"scene-file\" tabindex=\"0\"><code>{}</code></pre>\n",
      escape(report.scene.file), escape(report.scene.text));
}

std::string results(const SceneContents& contents) {
  const SceneReport& report = contents.report;
  return formula_section(report) + response_section(report) + explorer_section(report) +
         friction_section(report) + cycle_section(report) + parting_section(report) +
         indenter_section(report) + reduced_section(report) +
         (contents.accuracy ? accuracy_section(*contents.accuracy) : std::string()) +
         values_section(report);
}

}  // namespace

std::string title_of(const SceneReport& report) {
  return report.scene.title.empty() ? report.scene.file : report.scene.title;
}

const char* state_class(const SceneReport& report) {
  if (!passed(report)) return "failed";
  if (!report.reasons.empty()) return "outside";
  return count(report, Comparison::Outcome::not_run) > 0 ? "not-run" : "passed";
}

std::string state_words(const SceneReport& report) {
  const std::string words = count_words(report.comparisons);
  if (report.reasons.empty()) return words;
  return "Outside the model: no v*, not simulated" +
         (passed(report) ? std::string() : "; " + words);
}

std::string velocity_words(const SceneReport& report) {
  if (!report.failure.empty()) return "no v*";
  if (!report.reasons.empty()) return {};
  if (report.indented && !report.indented->closed_form)
    return "v* = " + quantity(report.indented->critical_velocity, "m/s", 5) + ", simulated";
  if (report.parting && !report.parting->closed_form)
    return std::isinf(report.parting->critical_velocity)
               ? "no v*"
               : "v* = " + quantity(report.parting->critical_velocity, "m/s", 5) + ", simulated";
  return "v* = " + quantity(report.critical_velocity, "m/s", 5);
}

std::string scene_section(const SceneContents& contents) {
  const SceneReport& report = contents.report;
  return "<section class=\"scene\">\n" + scene_verdict(report) + drawings(report) +
         comparisons_section(report) +
         (report.failure.empty() ? results(contents) : std::string()) + file_section(report) +
         "</section>\n";
}

}  // namespace vcrit::validation::report
