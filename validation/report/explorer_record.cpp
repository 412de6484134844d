#include "report/explorer_record.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "compare/explorer.hpp"
#include "figures/figure_json.hpp"
#include "problem/variants.hpp"
#include "report/assets.hpp"
#include "report/html.hpp"
#include "report/scene_figures.hpp"

namespace vcrit::validation::report {

namespace {

using figures::Figure;
using figures::FigureSeries;
using figures::Style;
using nlohmann::ordered_json;

bool has_friction(const SceneReport& report) {
  return report.explorer->friction && !report.curve.empty();
}

bool has_explorer(const SceneReport& report) {
  return report.explorer && !report.response.points.empty();
}

/// The series named "now" is what the sliders say; explorer.js gives it new points. The scene's
/// own, dashed and of another colour, lies on top: where both are one curve, both are seen.
std::vector<FigureSeries> now_and_own(const FigureSeries& own) {
  return {{"now", Style::line, own.points, 0}, {"this scene", Style::dashed, own.points, 1}};
}

ordered_json response_chart(const SceneReport& report) {
  Figure figure = velocity_response_figure(report);
  const FigureSeries own = figure.series.back();
  std::erase_if(figure.series, [](const FigureSeries& s) { return s.style != Style::dotted; });
  for (const FigureSeries& series : now_and_own(own)) figure.series.push_back(series);
  figure.rules.resize(1);
  figure.rules.front().words = "ω of the scene";
  figure.height = 260;
  return figure_json(figure);
}

ordered_json friction_chart(const SceneReport& report) {
  Figure figure = friction_figure(report);
  figure.series = now_and_own(figure.series.front());
  figure.height = 260;
  return figure_json(figure);
}

ordered_json slider_json(const Slider& slider) {
  return {{"name", slider.name},
          {"array", slider.array},
          {"unit", slider.unit},
          {"values", slider.values},
          {"role", slider.meaning}};
}

ordered_json grid_json(const FrictionGrid& grid) {
  ordered_json rows = ordered_json::array();
  for (const auto& row : grid.friction) {
    ordered_json numbers = ordered_json::array();
    for (const double value : row)
      numbers.push_back(std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr));
    rows.push_back(std::move(numbers));
  }
  return {{"ratios", grid.ratios},
          {"amplitudes", grid.amplitudes},
          {"amplitude_ratios", grid.amplitude_ratios},
          {"friction", std::move(rows)}};
}

/// All numbers of the scene by name; an array's entries are in their order.
ordered_json values_json(const SceneReport& report) {
  ordered_json values = ordered_json::object();
  const Problem problem = called_otherwise(report.problem, names_in_page(report.problem));
  for (const auto& [symbol, value] : problem.values()) {
    const std::string name = as_called(problem, symbol).name;
    if (symbol.entry == 0)
      values[name] = value;
    else
      values[name].push_back(value);
  }
  return values;
}

ordered_json data(const SceneReport& report) {
  const Explorer& explorer = *report.explorer;
  ordered_json object{{"sliders", ordered_json::array()},
                      {"values", values_json(report)},
                      {"unit", explorer.unit},
                      {"carries_load", explorer.carries_load},
                      {"may_open", report.problem->separation},
                      {"response", response_chart(report)}};
  for (const Slider& slider : explorer.sliders) object["sliders"].push_back(slider_json(slider));
  ordered_json omegas = ordered_json::array();
  for (const ResponsePoint& point : report.response.points) omegas.push_back(point.omega);
  object["omegas"] = std::move(omegas);
  if (has_friction(report)) {
    object["grid"] = grid_json(*explorer.friction);
    object["friction"] = friction_chart(report);
  }
  return object;
}

/// A slider moves over four decades around the scene's value; that of the frequency from stop to
/// stop of the friction grid.
ordered_json slider_row(const Slider& slider) {
  const std::string name = slider.array ? slider.label + ", all entries" : slider.label;
  const record::Fields page(record::Reader::page);
  return {
      {"label", slider.array ? page.written(name) : page.written(record::Markup{slider.mathml})},
      {"name", name},
      {"meaning", slider.meaning},
      {"step", slider.meaning == "angular frequency" ? 0.2 : 0.05}};
}

}  // namespace

record::Json explorer_record(const SceneReport& report) {
  if (!has_explorer(report)) return nullptr;
  ordered_json rows = ordered_json::array();
  for (const Slider& slider : report.explorer->sliders) rows.push_back(slider_row(slider));
  const record::Markup content{json_for_page(data(report))};
  return {{"sliders", std::move(rows)},
          {"friction", has_friction(report)},
          {"data", record::Fields(record::Reader::page).written(content)}};
}

std::vector<std::string> explorer_scripts(const SceneReport& report) {
  if (!has_explorer(report)) return {};
  return {report.explorer->script, std::string(explorer_script())};
}

}  // namespace vcrit::validation::report
