#include "figures/svg.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "base/errors.hpp"
#include "figures/drawn.hpp"
#include "record/fields.hpp"
#include "record/html_text.hpp"
#include "record/template.hpp"

extern "C" const char vcrit_figure_templates[], vcrit_figure_templates_end[];

namespace vcrit::validation::figures {

namespace {

using record::Json;

// Pixels. Letters are 13 high and at most about 7 wide.
constexpr double picture_width = 680, left_margin = 72, right_margin = 18, right_axis = 64;
constexpr double title_height = 34, untitled_height = 12, below_axis = 50, legend_row = 20,
                 letter_width = 7, line_height = 16;

struct Frame {
  const Figure& figure;
  FigureScales scales;
  double width, height;  ///< of the data

  double x(double value) const { return width * scales.x.place(value); }
  double y(double value) const { return height * (1 - scales.y.place(value)); }
};

/// On the picture: what lies far outside would be cut off in any case.
bool is_near(const Frame& frame, double x, double y) {
  return std::isfinite(x) && std::isfinite(y) && std::abs(x) < 4 * frame.width &&
         std::abs(y) < 4 * frame.height;
}

std::string path_of(const Frame& frame, const FigureSeries& series) {
  std::string path;
  bool pen_down = false;
  for (const Point& point : series.points) {
    const double x = frame.x(point.x), y = frame.y(point.y);
    if (is_near(frame, x, y)) path += fmt::format("{}{:.1f} {:.1f}", pen_down ? "L" : "M", x, y);
    pen_down = is_near(frame, x, y);
  }
  return path;
}

Json points_of(const Frame& frame, const FigureSeries& series) {
  Json all = Json::array();
  for (const Point& point : series.points)
    if (const double x = frame.x(point.x), y = frame.y(point.y); is_near(frame, x, y))
      all.push_back({{"x", x}, {"y", y}});
  return all;
}

/// How a series is drawn: as a line with these dashes, or as points with this shape.
struct Look {
  const char *dashes = "none", *shape = "";
};

const char* shape_path(Style style) {
  switch (style) {
    case Style::circles:
      return "M-4 0a4 4 0 1 0 8 0a4 4 0 1 0-8 0";
    case Style::dots:
      return "M-2 0a2 2 0 1 0 4 0a2 2 0 1 0-4 0";
    case Style::crosses:
      return "M-4-4L4 4M-4 4L4-4";
    case Style::squares:
      return "M-3.5-3.5h7v7h-7z";
    case Style::triangles:
      return "M0-4.5L4.3 3.5h-8.6z";
    case Style::diamonds:
      return "M0-5L4.5 0L0 5L-4.5 0z";
    case Style::line:
    case Style::dashed:
    case Style::dotted:
      return "";
    case Style::bars:
      break;
  }
  throw Bug("bars in a picture of lines and points");
}

Look look_of(const FigureSeries& series) {
  return {is_marks(series.style) ? "none" : dashes_of(series.style, series.colour),
          shape_path(series.style)};
}

Json drawn_series(const Frame& frame) {
  Json all = Json::array();
  for (const FigureSeries& series : frame.figure.series) {
    const auto [dashes, shape] = look_of(series);
    const bool line = *shape == 0;
    all.push_back({{"colour", palette(series.colour)},
                   {"dashes", dashes},
                   {"path", line ? Json(path_of(frame, series)) : Json()},
                   {"shape", shape},
                   {"points", line ? Json::array() : points_of(frame, series)}});
  }
  return all;
}

/// Names in a row above the frame, where there are two or more to tell apart.
Json legend_of(const Figure& figure) {
  Json all = Json::array();
  std::set<std::string> named{""};
  double at = 0;
  for (const FigureSeries& series : figure.series) {
    if (!named.insert(series.name).second) continue;
    const auto [dashes, shape] = look_of(series);
    all.push_back({{"x", at},
                   {"name", series.name},
                   {"colour", palette(series.colour)},
                   {"dashes", dashes},
                   {"shape", *shape != 0 ? Json(shape) : Json()}});
    at += 44 + letter_width * static_cast<double>(series.name.size());
  }
  return all.size() > 1 ? all : Json::array();
}

Json ticks_of(const Frame& frame, bool horizontal) {
  Json all = Json::array();
  const AxisScale& scale = horizontal ? frame.scales.x : frame.scales.y;
  for (const auto& [at, words] : scale.ticks()) {
    const double place = scale.place(at);
    if (place < -1e-6 || place > 1 + 1e-6) continue;
    all.push_back({{"at", horizontal ? frame.x(at) : frame.y(at)}, {"words", words}});
  }
  return all;
}

Json right_axis_of(const Frame& frame) {
  const FigureAxis& axis = *frame.figure.right;
  const AxisScale scale(axis, {}, frame.figure.height / 50);
  Json ticks = Json::array();
  for (const Tick& tick : scale.ticks())
    ticks.push_back({{"at", frame.height * (1 - scale.place(tick.at))}, {"words", tick.words}});
  return {{"edge", frame.width},
          {"long", frame.height},
          {"words_at", frame.width + 8},
          {"title_at", frame.width + right_axis - 8},
          {"title_half", frame.height / 2},
          {"title", axis.title},
          {"ticks", ticks}};
}

struct Box {
  double x, y, width, height;  ///< from its upper left corner

  bool holds(double px, double py) const {
    return px > x && px < x + width && py > y && py < y + height;
  }
  bool meets(const Box& other) const {
    return x < other.x + other.width && other.x < x + width && y < other.y + other.height &&
           other.y < y + height;
  }
};

/// Where words may stand: on no line, across no rule and on no other words. Where rules stand too
/// close for that, across them; they can be read there, unlike on other words.
class FreePlaces {
 public:
  explicit FreePlaces(const Frame& frame) : frame_(frame) {
    for (const FigureSeries& series : frame.figure.series) {
      double last_x = NAN, last_y = NAN;
      for (const Point& point : series.points) {
        const double x = frame.x(point.x), y = frame.y(point.y);
        if (is_near(frame, x, y)) add(curves_, last_x, last_y, x, y);
        last_x = x;
        last_y = y;
      }
    }
    for (const Rule& rule : frame.figure.rules)
      if (!rule.horizontal) add(rules_, frame.x(rule.at), 0, frame.x(rule.at), frame.height);
  }

  /// The first of these that is free, else the first; it is taken from now on.
  Box take(const std::vector<Box>& candidates) {
    auto found = std::ranges::find_if(
        candidates, [this](const Box& box) { return is_free(box) && !is_on(rules_, box); });
    if (found == candidates.end())
      found = std::ranges::find_if(candidates, [this](const Box& box) { return is_free(box); });
    words_.push_back(found == candidates.end() ? candidates.front() : *found);
    return words_.back();
  }

 private:
  using Places = std::vector<std::pair<double, double>>;

  /// A point each few pixels, nearer than words are high.
  static void add(Places& places, double from_x, double from_y, double x, double y) {
    constexpr double step = 4;
    const double length = std::hypot(x - from_x, y - from_y);
    if (std::isfinite(length))
      for (double at = 0; at < length; at += step)
        places.push_back(
            {from_x + (x - from_x) * at / length, from_y + (y - from_y) * at / length});
    places.push_back({x, y});
  }

  static bool is_on(const Places& places, const Box& box) {
    return std::ranges::any_of(places,
                               [&](const auto& at) { return box.holds(at.first, at.second); });
  }

  bool is_free(const Box& box) const {
    return box.x >= 0 && box.x + box.width <= frame_.width && box.y >= 0 &&
           box.y + box.height <= frame_.height && !is_on(curves_, box) &&
           std::none_of(words_.begin(), words_.end(),
                        [&](const Box& other) { return box.meets(other); });
  }

  const Frame& frame_;
  Places curves_, rules_;
  std::vector<Box> words_;
};

/// Beside the rule, from the top down.
std::vector<Box> places_beside(const Frame& frame, const Rule& rule) {
  const double length = letter_width * static_cast<double>(rule.words.size()), gap = 6;
  std::vector<Box> all;
  if (rule.horizontal) {
    const double y = frame.y(rule.at);
    for (const double x : {gap, frame.width - gap - length})
      for (const double top : {y - line_height, y + 2})
        all.push_back({x, top, length, line_height});
    return all;
  }
  const double x = frame.x(rule.at);
  for (double top = 2; top + line_height < frame.height; top += line_height)
    for (const double left : {x + gap, x - gap - length})
      all.push_back({left, top, length, line_height});
  return all;
}

Json drawn_rules(const Frame& frame) {
  Json all = Json::array();
  FreePlaces places(frame);
  for (const Rule& rule : frame.figure.rules) {
    const double place =
        rule.horizontal ? frame.scales.y.place(rule.at) : frame.scales.x.place(rule.at);
    if (!(place >= 0 && place <= 1)) continue;
    const Box words = places.take(places_beside(frame, rule));
    all.push_back({{"at", rule.horizontal ? frame.y(rule.at) : frame.x(rule.at)},
                   {"horizontal", rule.horizontal},
                   {"words", rule.words},
                   {"x", words.x},
                   {"y", words.y + 12}});
  }
  return all;
}

Json drawn_bands(const Frame& frame) {
  Json all = Json::array();
  for (const Band& band : frame.figure.bands) {
    const double from = std::clamp(frame.x(band.from), 0.0, frame.width),
                 to = std::clamp(frame.x(band.to), 0.0, frame.width);
    const bool has_room = to - from > letter_width * static_cast<double>(band.words.size());
    all.push_back({{"x", from},
                   {"width", to - from},
                   {"middle", (from + to) / 2},
                   {"words", has_room ? band.words : ""}});
  }
  return all;
}

}  // namespace

namespace {

/// One figure below `top`, which moves to its end.
Json panel(const Figure& figure, bool titled, double& top) {
  if (figure.map) throw Bug("a map in a picture of lines and points");
  const double margin = figure.right ? right_axis : right_margin;
  const Frame frame{figure, scales_of(figure, 7, figure.height / 50),
                    picture_width - left_margin - margin, static_cast<double>(figure.height)};
  const Json legend = legend_of(figure);
  top += (titled ? title_height : untitled_height) + (legend.empty() ? 0 : legend_row);
  Json all{{"name", figure.name},
           {"top", top},
           {"left", left_margin},
           {"width", frame.width},
           {"height", frame.height},
           {"middle", frame.width / 2},
           {"half", frame.height / 2},
           {"band_words_at", frame.height - 8},
           {"tick_words_at", frame.height + 19},
           {"x_title_at", frame.height + 40},
           {"clipped_width", frame.width + 2},
           {"clipped_height", frame.height + 2},
           {"title", titled ? figure.title : ""},
           {"title_at", legend.empty() ? -14.0 : -14.0 - legend_row},
           {"x_title", figure.x.title},
           {"y_title", figure.y.title},
           {"x_ticks", ticks_of(frame, true)},
           {"y_ticks", ticks_of(frame, false)},
           {"bands", drawn_bands(frame)},
           {"series", drawn_series(frame)},
           {"rules", drawn_rules(frame)},
           {"legend", legend},
           {"right", figure.right ? right_axis_of(frame) : Json()}};
  top += frame.height + below_axis;
  return all;
}

std::string picture_of(const char* name, const std::vector<Figure>& figures, bool titled) {
  Json panels = Json::array();
  double height = 0;
  std::string words;
  for (const Figure& figure : figures) {
    panels.push_back(panel(figure, titled, height));
    words += (words.empty() ? "" : " ") + figure.title + ". " + figure.caption;
  }
  static const record::Templates templates(
      {vcrit_figure_templates,
       static_cast<std::size_t>(vcrit_figure_templates_end - vcrit_figure_templates)},
      record::html_text);
  return templates.render(
      name, {{"width", picture_width}, {"height", height}, {"words", words}, {"panels", panels}});
}

}  // namespace

std::string svg(const std::vector<Figure>& figures) {
  return picture_of("svg", figures, true) + "\n";
}

std::string still(const Figure& figure) { return picture_of("still", {figure}, false); }

}  // namespace vcrit::validation::figures
