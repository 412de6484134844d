#include "figures/gnuplot.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/errors.hpp"

namespace vcrit::validation::figures {

namespace {

/// In single quotes, where gnuplot substitutes nothing.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'') result += '\'';
    result += c == '\n' ? ' ' : c;
  }
  return result + "'";
}

std::string coordinate(double value, const FigureAxis& axis) {
  return std::isfinite(value) && !(axis.logarithmic && value <= 0) ? fmt::format("{:.9g}", value)
                                                                   : "NaN";
}

std::string ticks(const char* letter, const FigureAxis& axis) {
  std::string list;
  for (const auto& [at, words] : axis.ticks)
    list += fmt::format("{}{} {:.17g}", list.empty() ? "" : ", ", quoted(words), at);
  return list.empty() ? "" : fmt::format("set {}tics ({})\n", letter, list);
}

std::string axis(const char* letter, const FigureAxis& axis) {
  std::string text = fmt::format("set {}label {}\n", letter, quoted(axis.title));
  if (axis.logarithmic) text += fmt::format("set logscale {0}\nset format {0} '%h'\n", letter);
  if (axis.range)
    text += fmt::format("set {}range [{:.17g}:{:.17g}]\n", letter, axis.range->first,
                        axis.range->second);
  return text + ticks(letter, axis);
}

std::string bands(const Figure& figure) {
  std::string text;
  for (const Band& band : figure.bands)
    text += fmt::format(
        "set object rectangle from first {:.9g}, graph 0 to first {:.9g}, graph 1 behind "
        "fillcolor rgb '{}' fillstyle solid 0.16 noborder\n",
        band.from, band.to, palette(1));
  return text;
}

/// `row`: words of neighbours stand in different rows, one above the other.
std::string rule(const Rule& rule, int row) {
  const std::string at = fmt::format("first {:.9g}", rule.at);
  const auto place = [&](const std::string& other) {
    return rule.horizontal ? fmt::format("graph {}, {}", other, at)
                           : fmt::format("{}, graph {}", at, other);
  };
  std::string text = fmt::format("set arrow from {} to {} nohead dashtype 2 linecolor rgb '{}'\n",
                                 place("0"), place("1"), palette(2));
  if (!rule.words.empty())
    text += fmt::format("set label {} at {} offset character 0.6, 0.5\n", quoted(rule.words),
                        place(rule.horizontal ? "0.01" : fmt::format("{}", 0.01 + 0.05 * row)));
  return text;
}

std::string with(const FigureSeries& series) {
  const std::string colour = fmt::format("linecolor rgb '{}'", palette(series.colour));
  switch (series.style) {
    case Style::line:
      return "lines linewidth 2 " + colour;
    case Style::dashed:
      return "lines dashtype 2 linewidth 1.5 " + colour;
    case Style::dotted:
      return "lines dashtype 3 linewidth 1.5 " + colour;
    case Style::circles:
      return "points pointtype 6 pointsize 0.7 " + colour;
    case Style::dots:
      return "points pointtype 7 pointsize 0.7 " + colour;
    case Style::crosses:
      return "points pointtype 1 pointsize 0.9 " + colour;
    case Style::bars:
      return "boxes fillstyle solid 0.6 noborder " + colour;
  }
  throw Bug("a style without a way to plot it");
}

std::string data(const Figure& figure, const FigureSeries& series, std::size_t number_of) {
  std::string text = fmt::format("$series{} << END\n", number_of);
  for (const Point& point : series.points)
    text += fmt::format("{} {}\n", coordinate(point.x, figure.x), coordinate(point.y, figure.y));
  return text + "END\n";
}

std::string data(const Figure& figure, const Map& map) {
  const auto x = edges(map.x, figure.x.logarithmic), y = edges(map.y, figure.y.logarithmic);
  std::string text = "$map << END\n";
  for (std::size_t j = 0; j < map.y.size(); ++j)
    for (std::size_t i = 0; i < map.x.size(); ++i)
      text += fmt::format("{:.9g} {:.9g} {:.9g} {:.9g} {:.9g} {:.9g} {}\n", map.x[i], map.y[j],
                          x[i], x[i + 1], y[j], y[j + 1],
                          coordinate(map.values.at(j * map.x.size() + i), map.value));
  return text + "END\n";
}

std::string all_data(const Figure& figure) {
  std::string text = figure.map ? data(figure, *figure.map) : "";
  for (std::size_t i = 0; i < figure.series.size(); ++i) text += data(figure, figure.series[i], i);
  return text;
}

std::string plots(const Figure& figure) {
  std::vector<std::string> parts;
  if (figure.map)
    parts.emplace_back(
        "$map using 1:2:3:4:5:6:7 with boxxyerror fillstyle solid noborder fillcolor palette "
        "notitle");
  std::set<std::string> named{""};
  for (std::size_t i = 0; i < figure.series.size(); ++i) {
    const FigureSeries& series = figure.series[i];
    const std::string title =
        named.insert(series.name).second ? "title " + quoted(series.name) : "notitle";
    parts.push_back(fmt::format("$series{} using 1:2 with {} {}", i, with(series), title));
  }
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "plot " : ", \\\n  ") + part;
  return text.empty() ? "plot NaN notitle\n" : text + "\n";
}

// Viridis, as in the page.
constexpr const char* viridis =
    "set palette defined (0 '#440154', 1 '#3b528b', 2 '#21918c', 3 '#5ec962', 4 '#fde725')\n";

std::string colours(const FigureAxis& value) {
  if (value.ticks.empty()) return viridis;
  std::string all;
  const int classes = 1 + static_cast<int>(value.ticks.back().first);
  for (int i = 0; i < classes; ++i)
    all += fmt::format("{}{} '{}'", all.empty() ? "" : ", ", i, palette(i));
  return fmt::format("set palette maxcolors {} defined ({})\nset cbrange [-0.5:{}]\n", classes, all,
                     classes - 0.5);
}

std::string output(const Figure& figure, const char* terminal, const char* ending) {
  return fmt::format("set terminal {}\nset output '{}.{}'\n", terminal, figure.name, ending) +
         "replot\nunset output\n";
}

}  // namespace

std::string gnuplot(const Figure& figure) {
  std::string text = "# " + quoted(figure.title) + "\nset encoding utf8\nset terminal unknown\n" +
                     "set key top outside horizontal center\nset tics nomirror\nset border 3\n" +
                     "set boxwidth 0.9 relative\n" + axis("x", figure.x) + axis("y", figure.y);
  if (figure.map) text += axis("cb", figure.map->value) + colours(figure.map->value);
  text += bands(figure);
  int row = 0;
  for (const Rule& each : figure.rules) text += rule(each, row++ % 6);
  return text + all_data(figure) + plots(figure) +
         output(figure, "svg size 640,420 noenhanced font 'DejaVu Sans,12' background '#ffffff'",
                "svg") +
         output(figure, "pdfcairo size 12cm,8cm noenhanced font 'DejaVu Sans,9'", "pdf");
}

}  // namespace vcrit::validation::figures
