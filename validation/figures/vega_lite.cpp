#include "figures/vega_lite.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/errors.hpp"
#include "base/numbers.hpp"

namespace vcrit::validation::figures {

namespace {

using nlohmann::ordered_json;

const char* const neutral = palette(2);
const char* const shade = palette(1);

ordered_json drawn(double value, const FigureAxis& axis) {
  if (!std::isfinite(value) || (axis.logarithmic && value <= 0)) return nullptr;
  return to_double(fmt::format("{:.7g}", value)).value();
}

ordered_json scale(const FigureAxis& axis) {
  ordered_json result{{"zero", false}, {"nice", !axis.range}};
  if (axis.logarithmic) result = {{"type", "log"}, {"nice", !axis.range}};
  if (axis.range) result["domain"] = {axis.range->first, axis.range->second};
  return result;
}

/// Words in place of the numbers at an axis, as an expression of Vega.
std::string labels(const FigureAxis& axis) {
  std::string expression;
  for (const auto& [at, words] : axis.ticks)
    expression += fmt::format("abs(datum.value - {0:.17g}) <= 1e-9 * abs({0:.17g}) ? {1} : ", at,
                              ordered_json(words).dump());
  return expression + "''";
}

/// Powers of ten as "10⁷", between 0.001 and 1000 as they are; other numbers have a tick alone.
ordered_json logarithmic_axis() {
  const std::string exponent = "round(log(datum.value) / LN10)", size = "abs(" + exponent + ")";
  const auto digit = [](const std::string& number) {
    return fmt::format("substring('⁰¹²³⁴⁵⁶⁷⁸⁹', {0}, {0} + 1)", number);
  };
  const std::string power =
      fmt::format("'10' + ({} < 0 ? '⁻' : '') + ({} > 9 ? {} : '') + {}", exponent, size,
                  digit("floor(" + size + " / 10)"), digit("(" + size + " % 10)"));
  return {{"labelExpr", fmt::format("abs(log(datum.value) / LN10 - {}) > 1e-9 ? '' : {} > 3 ? {} : "
                                    "format(datum.value, '~g')",
                                    exponent, size, power)}};
}

ordered_json axis_of(const FigureAxis& axis) {
  if (axis.ticks.empty()) return axis.logarithmic ? logarithmic_axis() : ordered_json::object();
  ordered_json values = ordered_json::array();
  for (const auto& [at, words] : axis.ticks) values.push_back(at);
  return {{"values", values}, {"labelExpr", labels(axis)}, {"labelOverlap", true}};
}

ordered_json position(const char* field, const FigureAxis& axis) {
  return {{"field", field},
          {"type", "quantitative"},
          {"title", axis.title},
          {"scale", scale(axis)},
          {"axis", axis_of(axis)}};
}

ordered_json mark(const char* type, ordered_json more = ordered_json::object()) {
  more["type"] = type;
  return more;
}

ordered_json mark(Style style) {
  switch (style) {
    case Style::line:
      return mark("line", {{"strokeWidth", 2.2}});
    case Style::dashed:
      return mark("line", {{"strokeDash", {6, 4}}, {"strokeWidth", 1.6}});
    case Style::dotted:
      return mark("line", {{"strokeDash", {2, 3}}, {"strokeWidth", 1.6}});
    case Style::circles:
      return mark("point", {{"size", 34}, {"filled", false}});
    case Style::dots:
      return mark("point", {{"size", 30}, {"filled", true}});
    case Style::crosses:
      return mark("point", {{"size", 40}, {"shape", "cross"}, {"filled", true}});
    case Style::bars:
      return mark("rect", {{"opacity", 0.6}});
  }
  throw Bug("a style without a mark");
}

bool is_line(Style style) {
  return style == Style::line || style == Style::dashed || style == Style::dotted;
}

std::vector<double> middles(const FigureSeries& series) {
  std::vector<double> result;
  for (const Point& point : series.points) result.push_back(point.x);
  return result;
}

/// What a bar stands on.
double ground(const Figure& figure) {
  if (figure.y.range) return figure.y.range->first;
  return figure.y.logarithmic ? 0.5 : 0;
}

ordered_json rows(const Figure& figure, const FigureSeries& series) {
  const bool bars = series.style == Style::bars;
  const auto sides = bars ? edges(middles(series), figure.x.logarithmic) : std::vector<double>{};
  ordered_json result = ordered_json::array();
  for (std::size_t i = 0; i < series.points.size(); ++i) {
    const Point& point = series.points[i];
    ordered_json row{{"x", drawn(bars ? sides[i] : point.x, figure.x)},
                     {"y", drawn(point.y, figure.y)}};
    if (bars)
      row["x2"] = drawn(sides[i + 1], figure.x), row["y2"] = drawn(ground(figure), figure.y);
    if (is_line(series.style)) row["n"] = i;
    if (!point.words.empty()) row["words"] = point.words;
    result.push_back(std::move(row));
  }
  return result;
}

ordered_json tooltip(const Figure& figure, const FigureSeries& series) {
  const bool words = std::any_of(series.points.begin(), series.points.end(),
                                 [](const Point& point) { return !point.words.empty(); });
  if (words) return {{{"field", "words"}, {"type", "nominal"}, {"title", series.name}}};
  return {{{"field", "x"}, {"type", "quantitative"}, {"title", figure.x.title}, {"format", ".6g"}},
          {{"field", "y"}, {"type", "quantitative"}, {"title", figure.y.title}, {"format", ".7g"}}};
}

/// One scale of colours for all named series.
struct Legend {
  ordered_json names = ordered_json::array(), colours = ordered_json::array();
};

Legend legend(const Figure& figure) {
  Legend result;
  for (const FigureSeries& series : figure.series) {
    const bool known =
        std::find(result.names.begin(), result.names.end(), series.name) != result.names.end();
    if (series.name.empty() || known) continue;
    result.names.push_back(series.name);
    result.colours.push_back(palette(series.colour));
  }
  return result;
}

ordered_json colour(const FigureSeries& series, const Legend& legend) {
  if (series.name.empty()) return {{"value", palette(series.colour)}};
  return {{"datum", series.name},
          {"type", "nominal"},
          {"scale", {{"domain", legend.names}, {"range", legend.colours}}},
          {"legend", {{"title", nullptr}, {"orient", "top"}, {"labelLimit", 260}}}};
}

ordered_json layer(const Figure& figure, const FigureSeries& series, const Legend& legend) {
  ordered_json encoding{{"x", position("x", figure.x)},
                        {"y", position("y", figure.y)},
                        {"color", colour(series, legend)}};
  if (is_line(series.style))
    encoding["order"] = {{"field", "n"}, {"type", "quantitative"}};
  else
    encoding["tooltip"] = tooltip(figure, series);
  if (series.style == Style::bars)
    encoding["x2"] = {{"field", "x2"}}, encoding["y2"] = {{"field", "y2"}};
  return {{"data", {{"values", rows(figure, series)}}},
          {"mark", mark(series.style)},
          {"encoding", std::move(encoding)}};
}

ordered_json drawn(const std::vector<double>& values, const FigureAxis& axis) {
  ordered_json result = ordered_json::array();
  for (const double value : values) result.push_back(drawn(value, axis));
  return result;
}

/// The colours of a map that has few values, with words for them.
ordered_json classes(const FigureAxis& axis) {
  ordered_json domain = ordered_json::array(), range = ordered_json::array();
  for (const auto& [at, words] : axis.ticks) {
    domain.push_back(at);
    range.push_back(palette(static_cast<int>(at)));
  }
  return {{"field", "v"},
          {"type", "ordinal"},
          {"title", axis.title},
          {"scale", {{"domain", std::move(domain)}, {"range", std::move(range)}}},
          {"legend", {{"labelExpr", labels(axis)}}}};
}

ordered_json layer(const Figure& figure, const Map& map) {
  const ordered_json seen{{"field", "v"}, {"type", "quantitative"}, {"title", map.value.title}};
  const bool few = !map.value.ticks.empty();
  ordered_json fill = few ? classes(map.value) : seen;
  if (!few) {
    fill["scale"] = scale(map.value);
    fill["scale"]["scheme"] = "viridis";
  }
  fill["legend"]["orient"] = "top";
  fill["legend"]["titleLimit"] = 400;
  const ordered_json grid{{"x", drawn(edges(map.x, figure.x.logarithmic), figure.x)},
                          {"y", drawn(edges(map.y, figure.y.logarithmic), figure.y)},
                          {"v", drawn(map.values, map.value)}};
  ordered_json encoding{{"x", position("x", figure.x)},
                        {"x2", {{"field", "x2"}}},
                        {"y", position("y", figure.y)},
                        {"y2", {{"field", "y2"}}},
                        {"fill", std::move(fill)}};
  if (!few) encoding["tooltip"] = seen;
  return {{"data", {{"grid", grid}}},
          {"mark", mark("rect", {{"clip", true}})},
          {"encoding", std::move(encoding)}};
}

ordered_json layer(const Figure& figure, const std::vector<Band>& bands) {
  ordered_json rows = ordered_json::array();
  for (const Band& band : bands)
    rows.push_back({{"x", drawn(band.from, figure.x)},
                    {"x2", drawn(band.to, figure.x)},
                    {"words", band.words}});
  return {{"data", {{"values", std::move(rows)}}},
          {"mark", mark("rect", {{"color", shade}, {"opacity", 0.16}, {"clip", true}})},
          {"encoding",
           {{"x", position("x", figure.x)},
            {"x2", {{"field", "x2"}}},
            {"tooltip", {{"field", "words"}, {"type", "nominal"}}}}}};
}

/// `row`: words of neighbours stand in different rows, one above the other.
void add(ordered_json& layers, const Figure& figure, const Rule& rule, int row) {
  const char* const along = rule.horizontal ? "y" : "x";
  const FigureAxis& axis = rule.horizontal ? figure.y : figure.x;
  const ordered_json data{{"values", {{{"at", drawn(rule.at, axis)}}}}};
  const ordered_json at = position("at", axis);
  layers.push_back(
      {{"data", data},
       {"mark", mark("rule", {{"color", neutral}, {"strokeDash", {4, 3}}, {"clip", true}})},
       {"encoding", {{along, at}}}});
  if (rule.words.empty()) return;
  ordered_json encoding{{along, at}};
  encoding[rule.horizontal ? "x" : "y"] = {
      {"value", rule.horizontal ? 6 : figure.height - 6 - 15 * row}};
  layers.push_back({{"data", data},
                    {"mark", mark("text", {{"align", "left"},
                                           {"dx", rule.horizontal ? 0 : 5},
                                           {"dy", rule.horizontal ? -4 : 0},
                                           {"baseline", "bottom"},
                                           {"text", rule.words}})},
                    {"encoding", std::move(encoding)}});
}

/// They would lie over the colours.
void take_grid_lines_away(ordered_json& layers) {
  for (ordered_json& layer : layers)
    for (const char* channel : {"x", "y"})
      if (layer["encoding"].contains(channel) && layer["encoding"][channel].contains("axis"))
        layer["encoding"][channel]["axis"]["grid"] = false;
}

/// A map fills its picture.
Figure with_ranges(Figure figure) {
  const auto set = [](FigureAxis& axis, const std::vector<double>& middles) {
    const std::vector<double> all = edges(middles, axis.logarithmic);
    if (!axis.range) axis.range = {all.front(), all.back()};
  };
  if (figure.map) {
    set(figure.x, figure.map->x);
    set(figure.y, figure.map->y);
  }
  return figure;
}

}  // namespace

ordered_json vega_lite(const Figure& given) {
  const Figure figure = with_ranges(given);
  ordered_json layers = ordered_json::array();
  if (figure.map) layers.push_back(layer(figure, *figure.map));
  if (!figure.bands.empty()) layers.push_back(layer(figure, figure.bands));
  const Legend names = legend(figure);
  for (const FigureSeries& series : figure.series) layers.push_back(layer(figure, series, names));
  int row = 0;
  for (const Rule& rule : figure.rules) add(layers, figure, rule, row++ % 6);
  if (figure.map) take_grid_lines_away(layers);
  return {{"width", "container"},
          {"height", figure.height},
          {"background", nullptr},
          {"description", figure.title},
          {"layer", std::move(layers)}};
}

}  // namespace vcrit::validation::figures
