#include "report/json_parts.hpp"

#include "report/html.hpp"

namespace vcrit::validation::report {

using nlohmann::ordered_json;

namespace {

ordered_json series_json(const figures::FigureSeries& series) {
  ordered_json points = ordered_json::array();
  for (const figures::Point& point : series.points)
    points.push_back({json_number(point.x), json_number(point.y)});
  return {{"name", series.name}, {"style", name_of(series.style)}, {"points", points}};
}

}  // namespace

ordered_json numbers(const std::vector<double>& values) {
  ordered_json array = ordered_json::array();
  for (const double value : values) array.push_back(json_number(value));
  return array;
}

ordered_json json(const Comparison& comparison) {
  const bool relative = comparison.measure == Comparison::Measure::relative;
  ordered_json object{{"key", comparison.key},
                      {"name", comparison.name},
                      {"reference", comparison.reference},
                      {"outcome", to_text(outcome(comparison))}};
  if (!comparison.not_run && !comparison.broken) {
    object["unit"] = comparison.unit;
    object["expected"] = json_number(comparison.expected);
    object["found"] = json_number(comparison.found);
    object["measure"] = relative ? "relative" : "absolute";
    object["difference"] = json_number(difference(comparison));
    object["tolerance"] = json_number(comparison.tolerance);
    object["tolerance_reason"] = comparison.reason;
  }
  if (!comparison.detail.empty()) object["detail"] = comparison.detail;
  return object;
}

ordered_json json(const Formula& formula) {
  return {{"text", formula.text}, {"latex", formula.latex}};
}

ordered_json json(const figures::Figure& figure) {
  ordered_json object{{"name", figure.name},
                      {"title", figure.title},
                      {"x", figure.x.title},
                      {"y", figure.y.title},
                      {"series", ordered_json::array()}};
  for (const figures::FigureSeries& each : figure.series)
    object["series"].push_back(series_json(each));
  if (figure.map)
    object["map"] = {{"value", figure.map->value.title},
                     {"x", numbers(figure.map->x)},
                     {"y", numbers(figure.map->y)},
                     {"values", numbers(figure.map->values)}};
  return object;
}

ordered_json json(const Machine& machine) {
  ordered_json versions = ordered_json::object();
  for (const auto& [name, version] : machine.versions) versions[name] = version;
  return {{"processor", machine.processor},
          {"cores", machine.cores},
          {"system", machine.system},
          {"commit", machine.commit},
          {"compiler_flags", machine.compiler_flags},
          {"versions", versions}};
}

ordered_json report_head(const Origin& origin, bool passed) {
  return {{"program", "vcrit"},
          {"version", origin.machine.program},
          {"passed", passed},
          {"command", origin.command},
          {"machine", json(origin.machine)}};
}

std::string text_of(const ordered_json& report) {
  return report.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace vcrit::validation::report
