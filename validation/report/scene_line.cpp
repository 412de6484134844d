#include "report/scene_line.hpp"

#include <nlohmann/json.hpp>

#include "report/verdict.hpp"

namespace vcrit::validation::report {

namespace {

std::vector<std::string> names(const SceneReport& report, Comparison::Outcome what) {
  std::vector<std::string> result;
  for (const Comparison& comparison : report.comparisons)
    if (outcome(comparison) == what) result.push_back(comparison.name);
  return result;
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
  visit("made", line.made);
  visit("failed", line.failed);
  visit("not_run", line.not_run);
  visit("warnings", line.warnings);
}

}  // namespace

SceneLine scene_line(const SceneReport& report) {
  return {report.problem->source->file,
          title_of(report),
          state_class(report),
          state_words(report),
          velocity_words(report),
          tightest_words(report.comparisons),
          report.comparisons.size() - count(report, Comparison::Outcome::not_run),
          names(report, Comparison::Outcome::failed),
          names(report, Comparison::Outcome::not_run),
          report.problem->source->warnings};
}

nlohmann::ordered_json to_json(const SceneLine& line) {
  nlohmann::ordered_json json;
  members(line, [&](const char* key, const auto& value) { json[key] = value; });
  return json;
}

SceneLine scene_line(const nlohmann::ordered_json& json) {
  SceneLine line;
  members(line, [&](const char* key, auto& value) { json.at(key).get_to(value); });
  return line;
}

}  // namespace vcrit::validation::report
