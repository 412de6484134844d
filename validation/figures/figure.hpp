// What a picture shows, whoever draws it: charts.js in the page (figure_json.hpp), gnuplot for
// papers (gnuplot.hpp). Plain data, in the units that the axes name.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vcrit::validation::figures {

struct FigureAxis {
  std::string title;  ///< with its unit: "time, µs"
  bool logarithmic = false;
  std::optional<std::pair<double, double>> range;  ///< none: what the data needs
  std::vector<std::pair<double, std::string>>
      ticks;  ///< where, and what is written; none: as usual
};

struct Point {
  double x = 0, y = 0;  ///< one that is not finite, or not positive on a logarithmic axis, is a gap
  std::string words;    ///< of this point, shown under a pointer; may be empty
};

enum class Style {
  line,
  dashed,
  dotted,
  circles,
  dots,
  crosses,
  squares,
  triangles,
  diamonds,
  bars
};

/// As written above.
const char* name_of(Style style);
/// Whether a series of that style is points, each on its own.
bool is_marks(Style style);
/// The shapes that tell so many series of points apart, also without colour. Wraps around.
Style shape_of(std::size_t number);

/// Series of one name share one entry of the legend and one colour; one without a name has none.
struct FigureSeries {
  std::string name;
  Style style = Style::line;
  std::vector<Point> points;  ///< a line goes through them in this order
  int colour = 0;             ///< of the palette: see palette()
};

/// A shaded stretch of the x axis.
struct Band {
  double from = 0, to = 0;
  std::string words;
};

/// A thin line across the picture, with words at its end.
struct Rule {
  double at = 0;
  std::string words;
  bool horizontal = false;  ///< at y = `at`, else at x = `at`
};

/// Colours over a grid. What has no value (NaN) stays empty.
struct Map {
  /// What the colour means; a range and a logarithm as of any axis; with ticks it has no other
  /// values than these, 0, 1, ..., and each has the colour of the palette.
  FigureAxis value;
  std::vector<double> x, y;    ///< middles of the cells, increasing, at least two of each
  std::vector<double> values;  ///< x.size() y.size() of them, a row of one y after the other
};

struct Figure {
  std::string name;     ///< of its files: small letters, digits, underscores
  std::string title;    ///< in a few words, for people who cannot see it and over its panel
  std::string caption;  ///< what it shows, in plain text
  FigureAxis x, y;
  std::optional<Map> map;            ///< under everything else
  std::vector<Band> bands;           ///< under the series
  std::vector<FigureSeries> series;  ///< later ones lie on top
  std::vector<Rule> rules;
  int height = 320;  ///< of the drawing on the page, in pixels
  /// At the right edge: what the heights of y mean in another unit. Its range, which it must have,
  /// is that of y in that unit.
  std::optional<FigureAxis> right;
};

/// Colours for paper, as "#rrggbb": 0 the main one, 1 the second, 2 for reference, 3 the third, 4
/// the fourth: told apart by everybody, whatever colours they see. Then 5 for what failed, 6 ink,
/// 7 for warnings. Wraps around. page.css has what stands for each in the dark.
const char* palette(int colour);

/// Of the classes of a map: those of the palette, but 2 is a pale grey, since areas have no dashes
/// that tell them apart in grey.
const char* class_colour(int number);

/// How a line is dashed, as SVG says it: one of style `line` by its colour, so that lines differ in
/// grey, too. "none" for a solid line.
const char* dashes_of(Style style, int colour);

/// The edges of cells around increasing middles: halfway between them, by ratio on a logarithmic
/// axis.
std::vector<double> edges(const std::vector<double>& middles, bool logarithmic);

/// A logarithmic axis that ends with the cells around these middles.
FigureAxis cells_axis(const std::string& title, const std::vector<double>& middles);

}  // namespace vcrit::validation::figures
