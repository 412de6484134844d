#include "accuracy/pictures.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "base/constants.hpp"
#include "base/sort_stably.hpp"

namespace vcrit::validation::accuracy {

namespace {

using figures::Figure;
using figures::FigureSeries;
using figures::Style;

// The same for units in the last place.
constexpr double no_ulps = 0.25;

constexpr double kilo_radians = two_pi * 1000;  // a second, at 1 kHz

struct Family {
  const char* name;
  std::vector<std::string> keys;
};

const std::vector<Family>& families() {
  static const std::vector<Family> all{
      {"generated, accurate", {"accurate", "accurate_batch", "accurate_sweep", "certified"}},
      {"generated, fast", {"fast", "fast_batch", "fast_sweep"}},
      {"as written", {"complex", "pasted"}},
      {"from the scene", {"library"}}};
  return all;
}

bool among(const std::string& key, const std::vector<std::string>& keys) {
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

std::string hover_words(const EvaluatorError& way) {
  return fmt::format("{}: {:.3g} ns, at worst {:.3g} ulp{}", way.name, way.nanoseconds, way.worst,
                     way.failure.empty() ? "" : "; failed: " + way.failure);
}

figures::Point point(const EvaluatorError& way) {
  return {way.nanoseconds, std::max(way.worst, no_ulps), hover_words(way)};
}

std::string hover_words(const Solve& solve) {
  return fmt::format("{} {}: {:.3g} µs, error {:.1e}{}", solve.method, solve.setting,
                     1e6 * solve.seconds, solve.error,
                     solve.failure.empty() ? "" : "; failed: " + solve.failure);
}

/// More is better; those of an error of 1 or more stand just above the axis.
double digits_kept(double error) {
  return std::clamp(-std::log10(std::max(error, no_error)), 0.05, 16.0);
}

figures::Point point(const Solve& solve) {
  return {1e6 * solve.seconds, digits_kept(solve.error), hover_words(solve)};
}

/// The points on the front, by cost.
template <class Item>
FigureSeries front(const std::vector<Item>& items) {
  FigureSeries series{"Pareto front", Style::dashed, {}, 2};
  for (const Item& item : items)
    if (item.on_front) series.points.push_back(point(item));
  sort_stably(series.points,
              [](const figures::Point& a, const figures::Point& b) { return a.x < b.x; });
  return series;
}

bool answered(const EvaluatorError& way) { return way.measured; }
bool answered(const Solve& solve) { return solve.answered; }

template <class Item>
FigureSeries failed(const std::vector<Item>& items) {
  FigureSeries series{"failed", Style::crosses, {}, 5};
  for (const Item& item : items)
    if (answered(item) && !item.failure.empty()) series.points.push_back(point(item));
  return series;
}

void add(Figure& figure, FigureSeries series) {
  if (!series.points.empty()) figure.series.push_back(std::move(series));
}

constexpr std::array colours{0, 1, 3, 4, 6, 2};

int colour_of(std::size_t i) { return colours.at(i % colours.size()); }

/// For legends.
std::string short_name(const std::string& key) {
  static const std::map<std::string, std::string> names{
      {"complex", "std::complex"}, {"fast_sweep", "fast, sweep"}, {"library", "from the scene"}};
  const auto found = names.find(key);
  return found == names.end() ? key : found->second;
}

FigureSeries histogram(const EvaluatorError& way, int colour) {
  FigureSeries series{short_name(way.key), Style::line, {}, colour};
  for (std::size_t i = 0; i + 1 < Histogram::size; ++i) {
    const double upper = Histogram::upper(i);
    const std::size_t count = way.histogram.counts[i];
    if (count > 0)
      series.points.push_back(
          {std::max(upper, no_ulps), static_cast<double>(count),
           fmt::format("{}: {} sets up to {:.3g} ulp", way.name, count, upper)});
  }
  return series;
}

std::string key_of(double ratio) { return fmt::format("{:03.0f}", 100 * ratio); }

/// A scene without a body does not hear of resonance.
std::string near_words(const EvaluatorErrors& errors) {
  if (errors.near_resonance + errors.near_antiresonance == 0) return {};
  return fmt::format(
      "; {} of them within a relative 10⁻² to 10⁻¹² of resonance, {} of antiresonance",
      errors.near_resonance, errors.near_antiresonance);
}

/// Without a name: the caption says what they are, their words what each is.
FigureSeries marks(const Layer& layer, bool asked) {
  FigureSeries series{"", asked ? Style::crosses : Style::dots, {}, asked ? 1 : 2};
  for (const Mark& mark : layer.marks)
    if (mark.words.starts_with("not asked") != asked)
      series.points.push_back({mark.omega / kilo_radians, mark.factor, mark.words});
  return series;
}

}  // namespace

Figure evaluator_picture(const EvaluatorErrors& errors) {
  Figure figure;
  figure.name = "evaluator_errors";
  figure.title = "Evaluators of v*: worst error over run time";
  figure.caption = fmt::format(
      "{} parameter sets, each number log-uniform in the decade around its value{}. An error of 0 "
      "stands at {}.",
      errors.sets, near_words(errors), no_ulps);
  figure.x = {"time a value, ns", true, {}, {}};
  figure.y = {"worst error, units in the last place", true, {}, {}};
  add(figure, front(errors.ways));
  for (std::size_t i = 0; i < families().size(); ++i) {
    FigureSeries series{families()[i].name, figures::shape_of(i), {}, colour_of(i)};
    for (const EvaluatorError& way : errors.ways)
      if (among(way.key, families()[i].keys) && way.measured && way.failure.empty())
        series.points.push_back(point(way));
    add(figure, std::move(series));
  }
  add(figure, failed(errors.ways));
  return figure;
}

Figure histogram_picture(const EvaluatorErrors& errors) {
  Figure figure;
  figure.name = "evaluator_histogram";
  figure.title = "Evaluators of v*: errors in units in the last place";
  figure.caption = fmt::format(
      "How many of the {} sets have an error of 0 (at {}), 1, 2, up to 4, up to 8, ... units in "
      "the "
      "last place of the correctly rounded value.",
      errors.sets, no_ulps);
  figure.x = {"error, units in the last place", true, {}, {}};
  figure.y = {"sets", true, {}, {}};
  std::size_t colour = 0;
  for (const EvaluatorError& way : errors.ways)
    if (way.measured &&
        among(way.key, {"accurate", "fast", "fast_sweep", "complex", "pasted", "library"}))
      add(figure, histogram(way, colour_of(colour++)));
  return figure;
}

Figure simulator_picture(const SpeedSolves& speed) {
  Figure figure;
  figure.name = "simulators_" + key_of(speed.ratio);
  figure.title = fmt::format("Simulators at a speed ratio of {}", speed.ratio);
  figure.caption =
      "Decimal digits kept over processor time, at this part of v*: up and left is better. "
      "Reference: " +
      speed.reference + ".";
  if (speed.agreement) figure.caption += " The exact method stands at that difference.";
  figure.x = {"time, µs", true, {}, {}};
  figure.y = {"digits kept of the friction ratio", false, std::pair{0.0, 16.5}, {}};
  add(figure, front(speed.solves));
  std::map<std::string, std::size_t> number;
  for (const Solve& solve : speed.solves) number.try_emplace(solve.method, number.size());
  for (const bool marked : {false, true})
    for (const auto& [method, own] : number) {
      FigureSeries series{
          method, marked ? figures::shape_of(own) : Style::line, {}, colour_of(own)};
      for (const Solve& solve : speed.solves)
        if (solve.method == method && solve.answered && solve.failure.empty())
          series.points.push_back(point(solve));
      if (marked || series.points.size() > 1) add(figure, std::move(series));
    }
  add(figure, failed(speed.solves));
  return figure;
}

std::string about_maps(const StabilityMap& map) {
  std::string words = fmt::format(
      "Each cell is one frequency and one factor on {}; its shade says how many of the 16 decimal "
      "digits of v* are lost.",
      map.name);
  if (!map.lines.empty())
    words +=
        " The lines are resonance, K_d = m ω², and antiresonance, K_t + K_d = m ω², with storage "
        "stiffnesses. A cell that a line crosses is taken at a relative distance of 10⁻⁸ from it.";
  return words;
}

Figure map_picture(const StabilityMap& map, const Layer& layer) {
  std::vector<double> kilohertz;
  for (const double omega : map.omega) kilohertz.push_back(omega / kilo_radians);
  Figure figure;
  figure.name = "map_" + map.key + "_" + layer.key;
  figure.title = layer.name;
  const FigureSeries wrong = marks(layer, true), not_asked = marks(layer, false);
  if (!wrong.points.empty())
    figure.caption = layer.key == "simulator"
                         ? "Crosses: at 1 ∓ 10⁻⁶ of the critical speed the simulation does not "
                           "stick below or slide above, or gives no answer."
                         : "Crosses: not finite.";
  if (!not_asked.points.empty())
    figure.caption += std::string(figure.caption.empty() ? "" : " ") +
                      "Dots: not simulated, as the stuck body oscillates too often in one period.";
  figure.x = figures::cells_axis("frequency, kHz", kilohertz);
  figure.y = figures::cells_axis("factor on " + map.name, map.factor);
  figure.map = figures::Map{
      {"digits lost", false, std::pair{0.0, 16.0}, {}}, kilohertz, map.factor, layer.lost};
  // More digits would only make the page longer.
  for (double& lost : figure.map->values) lost = std::round(100 * lost) / 100;
  int colour = 5;
  for (const MapLine& line : map.lines) {
    FigureSeries series{line.name, colour == 5 ? Style::dashed : Style::dotted, {}, colour};
    for (const auto& [omega, factor] : line.points)
      series.points.push_back({omega / kilo_radians, factor, line.name});
    add(figure, std::move(series));
    colour = 6;
  }
  add(figure, wrong);
  add(figure, not_asked);
  return figure;
}

std::vector<Figure> pictures(const Accuracy& accuracy) {
  std::vector<Figure> all{evaluator_picture(accuracy.evaluators),
                          histogram_picture(accuracy.evaluators)};
  for (const SpeedSolves& speed : accuracy.simulators) all.push_back(simulator_picture(speed));
  for (const StabilityMap& map : accuracy.maps)
    for (const Layer& layer : map.layers) all.push_back(map_picture(map, layer));
  return all;
}

}  // namespace vcrit::validation::accuracy
