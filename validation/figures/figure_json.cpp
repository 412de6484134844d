#include "figures/figure_json.hpp"

#include <fmt/core.h>

#include <cmath>

#include "base/numbers.hpp"

namespace vcrit::validation::figures {

namespace {

using nlohmann::ordered_json;

ordered_json drawn(double value, const FigureAxis& axis) {
  if (!std::isfinite(value) || (axis.logarithmic && value <= 0)) return nullptr;
  return to_double(fmt::format("{:.7g}", value)).value();
}

ordered_json drawn(const std::vector<double>& values, const FigureAxis& axis) {
  ordered_json result = ordered_json::array();
  for (const double value : values) result.push_back(drawn(value, axis));
  return result;
}

ordered_json json(const FigureAxis& axis) {
  ordered_json result{{"title", axis.title}, {"logarithmic", axis.logarithmic}};
  if (axis.range)
    result["range"] = {drawn(axis.range->first, axis), drawn(axis.range->second, axis)};
  for (const auto& [at, words] : axis.ticks) result["ticks"].push_back({drawn(at, axis), words});
  return result;
}

ordered_json json(const Point& point, const Figure& figure) {
  ordered_json result{drawn(point.x, figure.x), drawn(point.y, figure.y)};
  if (!point.words.empty()) result.push_back(point.words);
  return result;
}

ordered_json json(const FigureSeries& series, const Figure& figure) {
  ordered_json points = ordered_json::array();
  std::vector<double> middles;
  for (const Point& point : series.points) {
    points.push_back(json(point, figure));
    middles.push_back(point.x);
  }
  ordered_json result{{"name", series.name},
                      {"style", name_of(series.style)},
                      {"colour", palette(series.colour)},
                      {"dashes", dashes_of(series.style, series.colour)},
                      {"points", std::move(points)}};
  if (series.style == Style::bars)
    result["edges"] = drawn(edges(middles, figure.x.logarithmic), figure.x);
  return result;
}

ordered_json json(const Map& map, const Figure& figure) {
  ordered_json result{{"value", json(map.value)},
                      {"x", drawn(edges(map.x, figure.x.logarithmic), figure.x)},
                      {"y", drawn(edges(map.y, figure.y.logarithmic), figure.y)},
                      {"values", drawn(map.values, map.value)}};
  for (const auto& [at, words] : map.value.ticks)
    result["colours"].push_back(class_colour(static_cast<int>(at)));
  return result;
}

ordered_json json(const Band& band, const Figure& figure) {
  return {{"from", drawn(band.from, figure.x)},
          {"to", drawn(band.to, figure.x)},
          {"colour", palette(6)},
          {"words", band.words}};
}

ordered_json json(const Rule& rule, const Figure& figure) {
  return {{"at", drawn(rule.at, rule.horizontal ? figure.y : figure.x)},
          {"horizontal", rule.horizontal},
          {"colour", palette(2)},
          {"words", rule.words}};
}

template <class Item>
ordered_json list(const std::vector<Item>& items, const Figure& figure) {
  ordered_json result = ordered_json::array();
  for (const Item& item : items) result.push_back(json(item, figure));
  return result;
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

ordered_json figure_json(const Figure& given) {
  const Figure figure = with_ranges(given);
  ordered_json result{{"name", figure.name},
                      {"title", figure.title},
                      {"height", figure.height},
                      {"x", json(figure.x)},
                      {"y", json(figure.y)},
                      {"bands", list(figure.bands, figure)},
                      {"series", list(figure.series, figure)},
                      {"rules", list(figure.rules, figure)}};
  if (figure.right) result["right"] = json(*figure.right);
  if (figure.map) result["map"] = json(*figure.map, figure);
  return result;
}

}  // namespace vcrit::validation::figures
