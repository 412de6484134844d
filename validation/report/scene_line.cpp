#include "report/scene_line.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/rounded.hpp"
#include "report/answer_figures.hpp"
#include "report/answer_record.hpp"
#include "report/onset_speeds.hpp"
#include "report/units.hpp"
#include "report/verdict.hpp"

namespace vcrit::validation::report {

namespace {

std::vector<std::string> names(const SceneReport& report, Comparison::Outcome what) {
  std::vector<std::string> result;
  for (const Comparison& comparison : report.comparisons)
    if (outcome(comparison) == what) result.push_back(comparison.name);
  return result;
}

constexpr double spark_width = 96, spark_top = 4, spark_height = 22;  // px

/// Friction from 1 at the top to 0 at the bottom, the same for all scenes.
std::string path_of(const std::vector<std::pair<double, double>>& points, double end) {
  std::string path;
  for (const auto& [speed, friction] : points)
    path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", spark_width * speed / end,
                        spark_top + spark_height * (1 - friction));
  return path;
}

std::string answer_words(const SceneReport& report) {
  if (!report.failure.empty() && !report.effect) return "no answer";
  if (report.reasons.empty()) {
    const OnsetSpeeds onset = onset_speeds(report);
    return quantity(onset.contact, "m/s", 4) + (onset.simulated ? ", by simulation" : "");
  }
  const auto largest = closed_up_to(report);
  if (!largest) return "outside the model";
  return fmt::format("contact would open above {} (now {})", quantity(*largest, "m", 3),
                     quantity(report.problem.value(report.problem->amplitude), "m", 3));
}

/// Of a path that creeps there is no least value: at vanishing speed creep alone carries the
/// motion.
std::string reduction_words(const SceneReport& report) {
  if (report.reasons.empty() && report.creep_velocity > 0) return "creeps";
  if (!report.reasons.empty() || !report.effect || !report.effect->lowest) return {};
  return "−" + whole_percent(1 - *report.effect->lowest);
}

std::string frequency_words(const SceneReport& report) {
  return quantity(frequency_of(report), "Hz", 4);
}

/// Each member by its key, for reading and writing alike.
template <class Line, class Visit>
void members(Line& line, Visit visit) {
  visit("file", line.file);
  visit("title", line.title);
  visit("state", line.state);
  visit("state_words", line.state_words);
  visit("velocity", line.velocity);
  visit("tightest", line.tightest);
  visit("answer_words", line.answer_words);
  visit("reduction", line.reduction);
  visit("frequency", line.frequency);
  visit("spark", line.spark);
  visit("spark_onset", line.spark_onset);
  visit("made", line.made);
  visit("failed", line.failed);
  visit("not_run", line.not_run);
  visit("warnings", line.warnings);
}

}  // namespace

SceneLine scene_line(const SceneReport& report) {
  const auto points =
      report.reasons.empty() ? answer_points(report) : std::vector<std::pair<double, double>>{};
  const double end = points.empty() ? 1 : std::max(points.back().first, 1.0);
  return {report.problem->source->file,
          title_of(report),
          state_class(report),
          state_words(report),
          velocity_words(report),
          tightest_words(report.comparisons),
          answer_words(report),
          reduction_words(report),
          frequency_words(report),
          path_of(points, end),
          points.empty() ? "" : fmt::format("{:.1f}", spark_width / end),
          report.comparisons.size() - count(report, Comparison::Outcome::not_run),
          names(report, Comparison::Outcome::failed),
          names(report, Comparison::Outcome::not_run),
          report.problem->source->warnings};
}

SceneLine scene_line(const record::Json& json) {
  SceneLine line;
  members(line, [&](const char* key, auto& value) { json.at(key).get_to(value); });
  return line;
}

}  // namespace vcrit::validation::report

void vcrit::record::fields(Fields& f, const validation::report::SceneLine& line) {
  validation::report::members(line, [&](const char* key, const auto& value) { f(key, value); });
}
