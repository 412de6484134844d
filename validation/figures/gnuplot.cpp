#include "figures/gnuplot.hpp"

#include <fmt/core.h>

#include <cmath>
#include <set>

#include "base/errors.hpp"
#include "record/fields.hpp"
#include "record/template.hpp"

extern "C" const char vcrit_figure_templates[], vcrit_figure_templates_end[];

namespace vcrit::validation::figures {

namespace {

using record::Json;

/// For single quotes, in which gnuplot substitutes nothing.
std::string in_quotes(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '\'') result += '\'';
    result += c == '\n' ? ' ' : c;
  }
  return result;
}

std::string coordinate(double value, const FigureAxis& axis) {
  return std::isfinite(value) && !(axis.logarithmic && value <= 0) ? fmt::format("{:.9g}", value)
                                                                   : "NaN";
}

Json axis_record(const char* letter, const FigureAxis& axis) {
  Json ticks = Json::array(), range;
  for (const auto& [at, words] : axis.ticks) ticks.push_back({{"at", at}, {"words", words}});
  if (axis.range) range = {{"from", axis.range->first}, {"to", axis.range->second}};
  return {{"letter", letter},
          {"title", axis.title},
          {"logarithmic", axis.logarithmic},
          {"range", range},
          {"ticks", ticks}};
}

const char* way(Style style) {
  switch (style) {
    case Style::line:
      return "lines linewidth 2";
    case Style::dashed:
      return "lines dashtype 2 linewidth 1.5";
    case Style::dotted:
      return "lines dashtype 3 linewidth 1.5";
    case Style::circles:
      return "points pointtype 6 pointsize 0.7";
    case Style::dots:
      return "points pointtype 7 pointsize 0.7";
    case Style::crosses:
      return "points pointtype 1 pointsize 0.9";
    case Style::squares:
      return "points pointtype 4 pointsize 0.7";
    case Style::triangles:
      return "points pointtype 8 pointsize 0.8";
    case Style::diamonds:
      return "points pointtype 12 pointsize 0.9";
    case Style::bars:
      return "boxes fillstyle solid 0.6 noborder";
  }
  throw Bug("a style without a way to plot it");
}

Json series_record(const Figure& figure) {
  std::set<std::string> named{""};
  Json all = Json::array();
  for (const FigureSeries& series : figure.series) {
    Json points = Json::array();
    for (const Point& point : series.points)
      points.push_back(coordinate(point.x, figure.x) + " " + coordinate(point.y, figure.y));
    all.push_back({{"name", series.name},
                   {"titled", named.insert(series.name).second},
                   {"way", way(series.style)},
                   {"colour", palette(series.colour)},
                   {"points", std::move(points)}});
  }
  return all;
}

/// A map with ticks has a colour for each of its classes.
Json map_record(const Figure& figure) {
  const Map& map = *figure.map;
  const auto x = edges(map.x, figure.x.logarithmic), y = edges(map.y, figure.y.logarithmic);
  Json cells = Json::array(), colours = Json::array();
  for (std::size_t j = 0; j < map.y.size(); ++j)
    for (std::size_t i = 0; i < map.x.size(); ++i)
      cells.push_back(fmt::format("{:.9g} {:.9g} {:.9g} {:.9g} {:.9g} {:.9g} {}", map.x[i],
                                  map.y[j], x[i], x[i + 1], y[j], y[j + 1],
                                  coordinate(map.values.at(j * map.x.size() + i), map.value)));
  if (!map.value.ticks.empty())
    for (int i = 0; i <= static_cast<int>(map.value.ticks.back().first); ++i)
      colours.push_back(class_colour(i));
  const double last = static_cast<double>(colours.size()) - 0.5;
  return {{"cells", cells}, {"colours", colours}, {"last_class", last}};
}

/// Words of neighbours stand in different rows, one above the other.
constexpr int rows_of_words = 6;

Json rules_record(const Figure& figure) {
  Json all = Json::array();
  int row = 0;
  for (const Rule& rule : figure.rules)
    all.push_back({{"at", rule.at},
                   {"horizontal", rule.horizontal},
                   {"words", rule.words},
                   {"colour", palette(2)},
                   {"height", 0.01 + 0.05 * (row++ % rows_of_words)}});
  return all;
}

Json record_of(const Figure& figure) {
  Json axes{axis_record("x", figure.x), axis_record("y", figure.y)}, bands = Json::array();
  if (figure.right) axes.push_back(axis_record("y2", *figure.right));
  if (figure.map) axes.push_back(axis_record("cb", figure.map->value));
  for (const Band& band : figure.bands)
    bands.push_back({{"from", band.from}, {"to", band.to}, {"colour", palette(1)}});
  return {{"name", figure.name},
          {"title", figure.title},
          {"axes", axes},
          {"right", figure.right.has_value()},
          {"map", figure.map ? map_record(figure) : Json()},
          {"bands", bands},
          {"rules", rules_record(figure)},
          {"series", series_record(figure)},
          {"nothing", !figure.map && figure.series.empty()}};
}

std::string script(const char* name, const Json& record) {
  static const record::Templates templates(
      {vcrit_figure_templates,
       static_cast<std::size_t>(vcrit_figure_templates_end - vcrit_figure_templates)},
      in_quotes);
  return templates.render(name, record) + "\n";
}

}  // namespace

std::string gnuplot(const Figure& figure) { return script("gnuplot", record_of(figure)); }

std::string gnuplot_pages(const std::vector<Figure>& figures, const std::string& file) {
  Json pages = Json::array();
  for (const Figure& figure : figures) pages.push_back(record_of(figure));
  return script("gnuplot_pages", {{"file", file}, {"pages", pages}});
}

}  // namespace vcrit::validation::figures
