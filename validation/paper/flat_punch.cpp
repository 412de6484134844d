// mu_macro/mu0 = 1 - D G(v0/v*). Near 0, G = 1 - pi v + O(v^(3/2)): stick lasts x = 2 pi -
// sqrt(4 pi v) - v, and -G' = x^2/(4 pi). Near 1, with e = 1 - v and s0 = acos v,
//   2 pi G = (9/8) s0^4 - (3/40) s0^6 + ... = (9/2) e^2 (1 + e/5 + ...).
#include "paper/flat_punch.hpp"

#include <fmt/core.h>

#include <cmath>

#include "base/constants.hpp"
#include "compare/friction.hpp"
#include "paper/comparing.hpp"
#include "paper/motions.hpp"
#include "paper/references.hpp"

namespace vcrit::validation::paper {

namespace {

// Terms up to 20 over 2 pi, some twenty roundings; the simulation's share is divided by a.
constexpr double punch_rounding = 2e-14;
const char* const punch_rounding_reason = "twenty roundings of terms up to 4";

double closed_form(double ratio) { return 1 - elastic_friction(1, ratio); }
double simulated(double ratio) {
  return (1 - full_friction(0, reference_amplitude, ratio)) / reference_amplitude;
}
double fit(double ratio) { return 0.75 * std::pow(1 - ratio, 2) + 0.25 * std::pow(1 - ratio, 4); }

Comparison table(const char* key, const char* name, double (*value)(double)) {
  std::vector<Pair> pairs;
  for (const PunchReference& row : punch_references())
    pairs.push_back(
        {row.g, value(row.ratio), punch_rounding, fmt::format("worst at v₀/v* = {}", row.ratio)});
  return worst({key, name, "20 digits, computed with 50", punch_rounding_reason}, pairs);
}

Comparison slope_at_rest() {
  const double ratio = 1e-8, found = (closed_form(ratio) - 1) / ratio;
  return comparison({"punch_rest", "slope of G at rest, by v₀/v* = 10⁻⁸", "−π",
                     "⅔ √(4π v₀/v*) of shortened stick and as much again for what follows"},
                    {-pi, found, 4 / 3.0 * std::sqrt(4 * pi * ratio), ""});
}

Comparison end_of_reduction() {
  const double ratio = 0.999, e = 1 - ratio;
  return comparison({"punch_end", "simulated G at v₀/v* = 0.999", "9/(4π) (1 − v₀/v*)²",
                     "the next term, a fifth of 1 − v₀/v*, and half as much again",
                     Comparison::Measure::relative},
                    {9 / (4 * pi) * e * e, simulated(ratio), 0.3 * e, ""});
}

Comparison fit_band() {
  double most = 0;
  for (int i = 1; i < 1000; ++i)
    most = std::max(most, std::abs(fit(i / 1000.0) - closed_form(i / 1000.0)));
  return comparison({"punch_fit", "most that the fit ¾(1 − v)² + ¼(1 − v)⁴ is off G", "0.0144",
                     "half a unit of the last digit, which is given"},
                    {0.0144, most, 0.00005, ""});
}

figures::Figure punch_figure() {
  using figures::FigureSeries;
  using figures::Style;
  figures::Figure figure;
  figure.name = "flat_punch";
  figure.title = "Elastic contact";
  figure.caption =
      "G of the friction ratio 1 − D G for the elastic contact under a rigid drive. Circles: 20 "
      "digits.";
  figure.x = {"v₀ / v*", false, std::pair{0.0, 1.0}, {}};
  figure.y = {"G", false, std::pair{0.0, 1.0}, {}};
  FigureSeries closed{"closed form", Style::line, {}, 0}, often{"fit", Style::dashed, {}, 1};
  FigureSeries digits{"20 digits", Style::circles, {}, 2};
  for (int i = 1; i <= 100; ++i) {
    closed.points.push_back({i / 100.0, closed_form(i / 100.0), {}});
    often.points.push_back({i / 100.0, fit(i / 100.0), {}});
  }
  for (const PunchReference& row : punch_references())
    digits.points.push_back({row.ratio, row.g, {}});
  figure.series = {closed, often, digits};
  figure.height = 260;
  return figure;
}

}  // namespace

FlatPunch press_flat_punch() {
  FlatPunch result;
  for (const auto& [ratio, g] : punch_references())
    result.rows.push_back({ratio, g, closed_form(ratio), simulated(ratio), fit(ratio)});
  result.figure = punch_figure();
  result.comparisons = {table("punch_simulated", "G by simulation", simulated),
                        table("punch_closed", "G by its closed form", closed_form), slope_at_rest(),
                        end_of_reduction(), fit_band()};
  return result;
}

}  // namespace vcrit::validation::paper
