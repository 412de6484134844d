#include "paper/difference_map.hpp"

#include <fmt/core.h>

#include <cmath>

#include "compare/reduced_difference.hpp"
#include "paper/comparing.hpp"
#include "paper/references.hpp"

namespace vcrit::validation::paper {

namespace {

constexpr double allowed = 0.01;                    // of mu0: what the line calls usable
constexpr double slowest = 0.01, fastest = 0.9999;  // of v*, at which the difference is 0
constexpr int columns = 41, lines = 49;             // eight columns a decade, besides the first

std::vector<double> deltas() {
  std::vector<double> result;
  for (int i = 0; i < columns; ++i) result.push_back(std::pow(10, -2 + i / 8.0));
  return result;
}

std::vector<double> ratios() {
  std::vector<double> result;
  for (int i = 1; i <= lines; ++i) result.push_back(i / (lines + 1.0));
  return result;
}

double apart(double delta, double ratio) {
  return reduced_and_full(delta, ratio, reference_amplitude).difference();
}

/// The speed at which the difference falls to `allowed`; 0 where it is less at the slowest.
/// Bisection to a thousandth of a cell of the map.
double line_at(double delta) {
  double low = slowest, high = fastest;
  if (!(apart(delta, low) > allowed)) return 0;
  while (high - low > 2e-5) {
    const double middle = (low + high) / 2;
    (apart(delta, middle) > allowed ? low : high) = middle;
  }
  return (low + high) / 2;
}

figures::Figure map_figure(const ReducedTable& table) {
  figures::Figure figure;
  figure.name = "reduced_less_full";
  figure.title = "Reduced model less full motion";
  figure.caption = fmt::format(
      "Friction ratio by the reduced model less that of the full motion at {} of the largest "
      "amplitude; it is in proportion to the amplitude. On the line it is {}, to its left and "
      "above less.",
      reference_amplitude, allowed);
  figure.x = {"δ = ω c/k", true, std::nullopt, {}};
  figure.y = {"v₀ / v*", false, std::pair{0.0, 1.0}, {}};
  figures::Map map{{"difference", false, std::nullopt, {}}, table.deltas, table.ratios, {}};
  for (std::size_t j = 0; j < table.ratios.size(); ++j)
    for (const auto& row : table.rows) map.values.push_back(row[j].difference());
  figure.map = std::move(map);
  return figure;
}

void add_line(DifferenceMap& result, const std::vector<double>& along) {
  figures::FigureSeries line{fmt::format("off by {}", allowed), figures::Style::line, {}, 1};
  for (const double delta : along) {
    const double ratio = line_at(delta);
    if (ratio > 0)
      line.points.push_back(
          {delta, ratio, fmt::format("δ = {:.3g}, v₀/v* = {:.3f}", delta, ratio)});
    else
      result.safe_delta = delta;
  }
  result.figure.series.push_back(std::move(line));
}

double reference_of(std::span<const FrictionValue> rows, double delta, double ratio) {
  for (const FrictionValue& row : rows)
    if (row.delta == delta && row.ratio == ratio) return row.friction;
  throw Bug("no reference there");
}

/// At the points for which both models are known with more digits.
Comparison against_references() {
  std::vector<Pair> pairs;
  for (const double delta : {1.0, 10.0, 100.0})
    for (const double ratio : {0.1, 0.5})
      pairs.push_back({reference_of(reduced_references(), delta, ratio) -
                           reference_of(friction_references(), delta, ratio),
                       apart(delta, ratio), 2e-13,
                       fmt::format("worst at δ = {}, v₀/v* = {}", delta, ratio)});
  return worst({"difference", "the map’s difference", "both models in 13 digits",
                "a unit of the last digit of each"},
               pairs);
}

/// The reduced model drops a force that would take friction away: it never says too little.
Comparison least_difference(const ReducedTable& table) {
  std::vector<Pair> pairs;
  for (const auto& row : table.rows)
    for (const ReducedAndFull& pair : row)
      pairs.push_back({0, std::min(0.0, pair.difference()), 1e-9, ""});
  return worst(
      {"difference_sign", "most that the reduced model is below the full motion, on the map",
       "never below", "the full motion is promised to 10⁻⁹"},
      pairs);
}

}  // namespace

DifferenceMap map_difference() {
  const ReducedTable table = reduced_table(reference_amplitude, deltas(), ratios());
  DifferenceMap result{map_figure(table), allowed, 0, {}};
  add_line(result, table.deltas);
  result.comparisons = {against_references(), least_difference(table)};
  return result;
}

}  // namespace vcrit::validation::paper
