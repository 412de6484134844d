#include "paper/figure4.hpp"

#include <fmt/core.h>

#include <cmath>

#include "compare/friction.hpp"
#include "paper/comparing.hpp"
#include "paper/motions.hpp"
#include "paper/references.hpp"

namespace vcrit::validation::paper {

namespace {

using figures::Figure;
using figures::FigureSeries;
using figures::Style;
using Friction = double (*)(double delta, double a, double ratio);

// With the largest amplitude F_n touches zero; the motion needs F_n > 0.
constexpr double largest = 0.999999;
constexpr int amplitude_count = 5;  // besides 0

/// Of the largest; evenly from 0, since the paper does not say which it drew.
double share(int number) {
  return number == amplitude_count ? largest : double(number) / amplitude_count;
}

/// Denser where the curves bend most.
std::vector<double> figure4_ratios() {
  std::vector<double> ratios{0.002, 0.004, 0.007, 0.01, 0.015, 0.02, 0.03, 0.04};
  for (int i = 2; i <= 39; ++i) ratios.push_back(i / 40.0);
  for (const double ratio : {0.985, 0.995, 0.999}) ratios.push_back(ratio);
  return ratios;
}

double amplitude_ratio(double delta, double a) { return a / std::hypot(1, delta); }

template <class Value>
FigureSeries curve(const std::string& name, Style style, int colour, Value value) {
  FigureSeries series{name, style, {}, colour};
  for (const double ratio : figure4_ratios()) series.points.push_back({ratio, value(ratio), {}});
  series.points.push_back({1, 1, {}});
  return series;
}

std::string name_of(double delta, double a) {
  return fmt::format("{:.2g}", amplitude_ratio(delta, a));
}

void add_amplitude(Figure& figure, Friction friction, double delta, int number) {
  const double a = share(number), d = amplitude_ratio(delta, a);
  const std::string name = name_of(delta, a);
  figure.series.push_back(curve(name, Style::line, number, [&](double ratio) {
    return number == 0 ? 1 : friction(delta, a, ratio);
  }));
  if (number > 0)
    figure.series.push_back(curve(name, Style::dashed, number,
                                  [&](double ratio) { return elastic_friction(d, ratio); }));
}

void add_references(Figure& figure, Friction friction, double delta) {
  constexpr int colour = amplitude_count + 1;  // the first that no curve has
  const std::string name = name_of(delta, reference_amplitude);
  figure.series.push_back(curve(name, Style::dotted, colour, [&](double ratio) {
    return friction(delta, reference_amplitude, ratio);
  }));
  FigureSeries circles{name, Style::circles, {}, colour};
  for (const FrictionValue& row : friction_references())
    if (row.delta == delta)
      circles.points.push_back({row.ratio, row.friction, fmt::format("{:.15f}", row.friction)});
  figure.series.push_back(std::move(circles));
}

Figure panel(char letter, const char* model, const char* words, double delta, Friction friction) {
  Figure figure;
  figure.name = fmt::format("figure4{}_{}", letter, model);
  figure.title = fmt::format("{}) δ = {}, {}", letter, delta, words);
  figure.caption = fmt::format("By amplitude D, up to {:.4g}.", amplitude_ratio(delta, 1));
  figure.x = {"v₀ / v*", false, std::pair{0.0, 1.0}, {}};
  figure.y = {"μ macro / μ₀", false, std::pair{0.0, 1.05}, {}};
  for (int number = 0; number <= amplitude_count; ++number)
    add_amplitude(figure, friction, delta, number);
  add_references(figure, friction, delta);
  figure.height = 260;
  return figure;
}

/// Full motion against 25 digits.
Comparison full_against_references(double delta) {
  std::vector<Pair> pairs;
  for (const FrictionValue& row : friction_references()) {
    if (row.delta != delta) continue;
    const auto motion = full_motion(delta, reference_amplitude, row.ratio);
    pairs.push_back({row.friction, motion.friction_ratio,
                     motion.friction_ratio_error + friction_rounding,
                     fmt::format("worst at v₀/v* = {}", row.ratio)});
  }
  return worst({"figure4_full", fmt::format("Fig. 4, δ = {}: full motion", delta),
                "25 digits, Newton’s method on the events",
                "the simulator’s own estimate of its error, and a rounding of each"},
               pairs);
}

Comparison reduced_against(const FrictionValue& row) {
  return comparison(
      {"figure4_reduced",
       fmt::format("the reduced model, δ = {}, v₀/v* = {}", row.delta, row.ratio),
       "13 digits, computed apart", "a unit of the last digit given"},
      {row.friction, reduced_friction(row.delta, reference_amplitude, row.ratio), 1e-13, ""});
}

/// Without damping the full motion is that of the reduced model.
Comparison elastic_against(const FrictionValue& row) {
  const auto motion = full_motion(0, reference_amplitude, row.ratio);
  return comparison(
      {"elastic", fmt::format("full motion, δ = 0, v₀/v* = {}", row.ratio),
       "25 digits, event-driven",
       "the simulator’s own estimate of its error, and a rounding of each"},
      {row.friction, motion.friction_ratio, motion.friction_ratio_error + friction_rounding, ""});
}

/// Whatever moves is proportional to the oscillating part of F_n while v0/v* is kept.
void add_proportional(double delta, double ratio, std::vector<Pair>& pairs) {
  const auto known = full_motion(delta, reference_amplitude, ratio);
  for (int number = 1; number <= amplitude_count; ++number) {
    const double factor = share(number) / reference_amplitude;
    const auto found = full_motion(delta, share(number), ratio);
    pairs.push_back(
        {1 - factor * (1 - known.friction_ratio), found.friction_ratio,
         factor * known.friction_ratio_error + found.friction_ratio_error + 2 * friction_rounding,
         fmt::format("worst at δ = {}, v₀/v* = {}", delta, ratio)});
  }
}

Comparison proportionality() {
  std::vector<Pair> pairs;
  for (const double delta : figure4_deltas)
    for (const double ratio : {0.02, 0.3, 0.9}) add_proportional(delta, ratio, pairs);
  return worst({"figure4_linear", "Fig. 4: friction taken away, at every amplitude",
                "in proportion to D", "the simulator’s own estimates for both"},
               pairs);
}

}  // namespace

Figure4 draw_figure4() {
  Figure4 result;
  char letter = 'a';
  for (const double delta : figure4_deltas) {
    result.reduced.push_back(panel(letter, "reduced", "reduced model", delta, reduced_friction));
    result.full.push_back(panel(letter++, "full", "full motion", delta, full_friction));
    result.comparisons.push_back(full_against_references(delta));
  }
  for (const FrictionValue& row : reduced_references())
    result.comparisons.push_back(reduced_against(row));
  for (const FrictionValue& row : elastic_references())
    result.comparisons.push_back(elastic_against(row));
  result.comparisons.push_back(proportionality());
  return result;
}

}  // namespace vcrit::validation::paper
