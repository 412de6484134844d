#include "report/report_json.hpp"

#include <algorithm>

#include "report/html.hpp"
#include "report/json_parts.hpp"

namespace vcrit::validation::report {

namespace {

using nlohmann::ordered_json;
using report::json;  // beside those here

ordered_json json(const Equation& equation) {
  ordered_json object{{"left", json(equation.left)}, {"right", json(equation.right)}};
  if (!equation.words.empty()) object["words"] = equation.words;
  return object;
}

ordered_json json(const ValueLine& line) {
  return {{"name", to_text(line.symbol)},
          {"value", json_number(line.value)},
          {"unit", line.unit},
          {"meaning", line.meaning}};
}

ordered_json json(const CurvePoint& point) {
  ordered_json object{{"velocity_ratio", point.ratio},
                      {"velocity", point.velocity},
                      {"friction_ratio", json_number(point.from_sliding)},
                      {"friction_ratio_from_rest", json_number(point.from_rest)},
                      {"friction_ratio_error", json_number(point.error)},
                      {"regime", point.regime}};
  if (point.closed_form) object["friction_ratio_closed_form"] = *point.closed_form;
  return object;
}

ordered_json json(const simulation::CyclePoint& point) {
  return {{"phase", point.phase},
          {"contact_velocity", json_number(point.contact_velocity)},
          {"force", json_number(point.force)},
          {"friction_bound", json_number(point.friction_bound)}};
}

ordered_json json(const simulation::Event& event) {
  return {{"phase", event.phase}, {"to", to_text(event.to)}};
}

ordered_json json(const SceneReport& report);
ordered_json json(const LimitLine& limit);

template <class Item>
ordered_json list(const std::vector<Item>& items) {
  ordered_json array = ordered_json::array();
  for (const Item& item : items) array.push_back(json(item));
  return array;
}

ordered_json json(const LimitLine& limit) {
  return {{"name", limit.name},
          {"equation", limit.equation},
          {"result", json(limit.result)},
          {"definitions", list(limit.definitions)}};
}

ordered_json json(const Cycle& cycle) {
  return {{"velocity_ratio", cycle.ratio},
          {"velocity", cycle.velocity},
          {"friction_ratio", json_number(cycle.friction_ratio)},
          {"regime", cycle.regime},
          {"events", list(cycle.events)},
          {"points", list(cycle.points)}};
}

ordered_json json(const ReducedModel& model) {
  ordered_json object{{"delta", model.delta},
                      {"normal_force_amplitude_ratio", model.table.a},
                      {"tolerance", model.tolerance},
                      {"usable_from", nullptr},
                      {"table", ordered_json::array()}};
  if (model.usable_from) object["usable_from"] = *model.usable_from;
  for (std::size_t i = 0; i < model.table.deltas.size(); ++i)
    for (std::size_t j = 0; j < model.table.ratios.size(); ++j)
      object["table"].push_back({{"delta", model.table.deltas[i]},
                                 {"velocity_ratio", model.table.ratios[j]},
                                 {"reduced", json_number(model.table.rows[i][j].reduced)},
                                 {"full", json_number(model.table.rows[i][j].full)}});
  return object;
}

ordered_json failing(const SceneReport& report) {
  ordered_json keys = ordered_json::array();
  for (const Comparison& comparison : report.comparisons)
    if (outcome(comparison) == Comparison::Outcome::failed) keys.push_back(comparison.key);
  return keys;
}

ordered_json critical_velocity(const SceneReport& report) {
  ordered_json object{{"value", json_number(report.critical_velocity)},
                      {"relative_error_bound", json_number(report.relative_error_bound)},
                      {"condition_number", json_number(report.condition)}};
  if (!report.infinite_reason.empty()) object["reason"] = report.infinite_reason;
  if (report.creep_velocity > 0) {
    object["creep_velocity"] = json_number(report.creep_velocity);
    object["drive_velocity"] = json_number(report.critical_velocity + report.creep_velocity);
  }
  return object;
}

ordered_json json(const SceneReport& report) {
  ordered_json object{{"file", report.scene.file},
                      {"title", report.scene.title},
                      {"passed", passed(report)},
                      {"failed", failing(report)},
                      {"admissible", report.reasons.empty()},
                      {"reasons", report.reasons},
                      {"warnings", report.scene.warnings},
                      {"critical_velocity", critical_velocity(report)},
                      {"comparisons", list(report.comparisons)},
                      {"values", list(report.values)},
                      {"formula", json(report.formula)},
                      {"equation", report.equation},
                      {"definitions", list(report.definitions)},
                      {"derivation", list(report.derivation)},
                      {"limits", list(report.limits)}};
  if (!report.compiler.empty()) object["compiler"] = report.compiler;
  if (!report.curve.empty()) object["friction_curve"] = list(report.curve);
  if (report.cycle) object["cycle"] = json(*report.cycle);
  if (report.reduced_model) object["reduced_model"] = json(*report.reduced_model);
  object["text"] = report.scene.text;
  return object;
}

}  // namespace

bool passed(const Contents& contents) {
  return std::all_of(contents.scenes.begin(), contents.scenes.end(),
                     [](const SceneReport& report) { return validation::passed(report); });
}

std::string command(const Contents& contents) {
  std::string text = "vcrit validate";
  for (const SceneReport& report : contents.scenes) text += " " + shell_word(report.scene.file);
  return text + " --out report";
}

std::string report_json(const Contents& contents) {
  ordered_json report = report_head(contents.machine, passed(contents), command(contents));
  report["scenes"] = list(contents.scenes);
  return text_of(report);
}

}  // namespace vcrit::validation::report
