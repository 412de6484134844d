#include "report/report_json.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "report/accuracy_json.hpp"
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
  return {{"name", line.name.text},
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

ordered_json json(const LimitLine& limit);
ordered_json json(const MethodPoint& point);
ordered_json json(const MethodCurve& curve);
ordered_json json(const ResponsePoint& point);
ordered_json json(const AsymptoteLine& line);
ordered_json json(const FrictionCurve& curve);
ordered_json json(const ResonanceMark& mark);

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

ordered_json json(const MethodPoint& point) {
  ordered_json object{{"velocity_ratio", point.ratio}};
  if (!point.reason.empty()) {
    object["reason"] = point.reason;
  } else {
    object["friction_ratio"] = json_number(point.friction_ratio);
    object["difference"] = json_number(point.difference);
  }
  return object;
}

ordered_json json(const MethodCurve& curve) {
  return {{"method", curve.method}, {"setting", curve.setting}, {"points", list(curve.points)}};
}

ordered_json json(const ResponsePoint& point) {
  ordered_json object{{"angular_frequency", point.omega},
                      {"normal_stiffness", json_number(point.normal)},
                      {"tangential_stiffness", json_number(point.tangential)}};
  if (point.drive) object["drive_stiffness"] = json_number(*point.drive);
  object["critical_velocity"] = json_number(point.velocity);
  object["applies"] = point.applies;
  return object;
}

ordered_json json(const AsymptoteLine& line) {
  return {{"at", line.low ? "0" : "infinity"},
          {"power", line.power},
          {"coefficient", json_number(line.coefficient)},
          {"formula", json(line.formula)},
          {"definitions", list(line.definitions)}};
}

ordered_json json(const ResonanceMark& mark) {
  return {{"angular_frequency", mark.omega},
          {"kind", mark.resonance ? "resonance" : "antiresonance"}};
}

ordered_json json(const FrequencyResponse& response) {
  return {{"points", list(response.points)},
          {"asymptotes", list(response.asymptotes)},
          {"extremes", list(response.marks)}};
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

ordered_json json(const FrictionCurve& curve) {
  ordered_json ratios = ordered_json::array();
  for (const double value : curve.friction) ratios.push_back(json_number(value));
  return {{"name", curve.name},
          {"own", curve.own},
          {"velocity_ratio", curve.ratios},
          {"friction_ratio", std::move(ratios)}};
}

ordered_json json(const StateMap& map, const char* rows_are) {
  ordered_json rows = ordered_json::array();
  for (std::size_t row = 0; row < map.rows.size(); ++row) {
    ordered_json states = ordered_json::array();
    for (std::size_t i = 0; i < map.phases.size(); ++i) {
      const auto& motion = map.motions[row * map.phases.size() + i];
      states.push_back(motion ? ordered_json(to_text(*motion)) : ordered_json());
    }
    rows.push_back(std::move(states));
  }
  return {{rows_are, map.rows}, {"phase", map.phases}, {"states", std::move(rows)}};
}

ordered_json json(const Indented& indented) {
  ordered_json map = json(indented.map, "place");
  map["velocity_ratio"] = indented.map_ratio;
  return {{"critical_velocity_by", indented.closed_form ? "formula" : "simulation"},
          {"critical_velocity", json_number(indented.critical_velocity)},
          {"contact_radius", indented.radius},
          {"largest_contact_radius", indented.edge},
          {"mean_normal_force", indented.normal_force},
          {"amplitudes", list(indented.amplitudes)},
          {"shapes", list(indented.shapes)},
          {"state_map", std::move(map)}};
}

ordered_json json(const Parting& parting) {
  return {{"opens", parting.opens},
          {"critical_velocity_by", parting.closed_form ? "formula" : "simulation"},
          {"critical_velocity", json_number(parting.critical_velocity)},
          {"border", json_number(parting.border)},
          {"derivation", list(parting.derivation)},
          {"curves", list(parting.curves)},
          {"state_map", json(parting.map, "velocity_ratio")}};
}

ordered_json failing(const SceneReport& report) {
  ordered_json keys = ordered_json::array();
  for (const Comparison& comparison : report.comparisons)
    if (outcome(comparison) == Comparison::Outcome::failed) keys.push_back(comparison.key);
  return keys;
}

ordered_json velocity_json(const SceneReport& report) {
  ordered_json object{{"value", json_number(report.critical_velocity)},
                      {"relative_error_bound", json_number(report.relative_error_bound)},
                      {"condition_number", json_number(report.condition)}};
  if (!report.infinite_reason.empty()) object["reason"] = report.infinite_reason;
  if (!report.free_harmonics.empty()) {
    object["sliding_from"] = json_number(report.sliding_from);
    object["free_harmonics"] = report.free_harmonics;
  }
  if (report.creep_velocity > 0) {
    object["creep_velocity"] = json_number(report.creep_velocity);
    object["drive_velocity"] = json_number(report.critical_velocity + report.creep_velocity);
  }
  return object;
}

void add_results(const SceneContents& contents, ordered_json& object) {
  const SceneReport& report = contents.report;
  object["admissible"] = report.reasons.empty();
  object["reasons"] = report.reasons;
  object["critical_velocity"] = velocity_json(report);
  object["values"] = list(report.values);
  object["formula"] = json(report.formula);
  object["equation"] = report.equation;
  object["definitions"] = list(report.definitions);
  object["derivation"] = list(report.derivation);
  object["limits"] = list(report.limits);
  if (!report.compiler.empty()) object["compiler"] = report.compiler;
  if (!report.curve.empty()) object["friction_curve"] = list(report.curve);
  if (!report.methods.empty()) object["methods"] = list(report.methods);
  if (!report.response.points.empty()) object["frequency_response"] = json(report.response);
  if (report.cycle) object["cycle"] = json(*report.cycle);
  if (report.parting) object["separation"] = json(*report.parting);
  if (report.indented) object["indenter"] = json(*report.indented);
  if (report.reduced_model) object["reduced_model"] = json(*report.reduced_model);
  if (contents.accuracy) object["accuracy"] = accuracy_json(*contents.accuracy);
}

}  // namespace

ordered_json scene_json(const SceneContents& contents) {
  const SceneReport& report = contents.report;
  ordered_json object{
      {"file", report.scene.file},         {"title", report.scene.title},
      {"passed", passed(report)},          {"failed", failing(report)},
      {"warnings", report.scene.warnings}, {"comparisons", list(report.comparisons)}};
  if (report.failure.empty()) add_results(contents, object);
  object["text"] = report.scene.text;
  return object;
}

std::string command(const std::vector<std::string>& scene_files) {
  std::string text = "vcrit validate";
  for (const std::string& file : scene_files) text += " " + shell_word(file);
  return text + " --out report";
}

std::string report_json(const Origin& origin, const std::vector<ordered_json>& scenes) {
  const bool passed = std::all_of(scenes.begin(), scenes.end(), [](const ordered_json& scene) {
    return scene.at("passed").get<bool>();
  });
  ordered_json report = report_head(origin, passed);
  report["scenes"] = scenes;
  return text_of(report);
}

}  // namespace vcrit::validation::report
