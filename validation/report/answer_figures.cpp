#include "report/answer_figures.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>

#include "base/constants.hpp"
#include "base/rounded.hpp"
#include "report/answer_record.hpp"
#include "report/onset_speeds.hpp"
#include "report/units.hpp"
#include "stiffness/dynamic_stiffness.hpp"

namespace vcrit::validation::report {

namespace {

using figures::Figure;
using figures::FigureSeries;
using figures::Point;
using figures::Style;

constexpr double drawn_beyond = 1.3;  // so that one sees that nothing is gained above v*

std::optional<double> lowest_of(const SceneReport& report) {
  return report.effect ? report.effect->lowest : std::nullopt;
}

/// (m/s, ratio) by increasing speed; empty where nothing was simulated.
std::vector<Point> friction_points(const SceneReport& report) {
  std::vector<Point> points;
  if (const auto lowest = lowest_of(report)) points.push_back({0, *lowest, "at rest"});
  for (const ComparedPoint& point : report.curve)
    points.push_back({point.velocity, point.from_sliding, motion_words(point.regime)});
  if (!report.indented) return points;
  for (const FrictionCurve& curve : report.indented->amplitudes)
    for (std::size_t i = 0; curve.own && i < curve.ratios.size(); ++i)
      points.push_back({curve.ratios[i] * report.critical_velocity, curve.friction[i], ""});
  return points;
}

/// The middle of those that have a place on a logarithmic axis; 1 without any.
double middle_value(std::vector<double> values) {
  std::erase_if(values, [](double value) { return !(value > 0) || !std::isfinite(value); });
  if (values.empty()) return 1;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// An axis of frequency, two decades to both sides, with the scene's own and resonances marked.
Figure marked_frequencies(const SceneReport& report, const char* name, double factor,
                          const std::string& unit) {
  const double own = frequency_of(report);
  const auto& points = report.response.points;
  Figure figure;
  figure.name = name;
  figure.x = {"frequency, " + unit,
              true,
              std::pair{std::max(points.front().omega / two_pi, own / 100) * factor,
                        std::min(points.back().omega / two_pi, own * 100) * factor},
              {}};
  figure.rules.push_back({own * factor, fmt::format("now {:.4g}", own * factor), false});
  for (const ResonanceMark& mark : report.response.marks)
    figure.rules.push_back({mark.omega / two_pi * factor,
                            fmt::format("{} {:.3g}", mark.resonance ? "resonance" : "antiresonance",
                                        mark.omega / two_pi * factor),
                            false});
  return figure;
}

/// Of v*: what is farther from the middle than this is a resonance or an antiresonance, without an
/// end where nothing is lost.
constexpr double clipped = 100;

std::pair<double, double> shown_range(const std::vector<double>& values) {
  const double middle = middle_value(values);
  double low = middle, high = middle;
  for (const double value : values) {
    if (!(value > 0) || !std::isfinite(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  low = std::max(low, middle / clipped);
  high = std::min(high, middle * clipped);
  return {low / 1.2, std::max(high, low * 2) * 1.2};
}

/// N without vibration, of a contact that stays closed; NaN where that is not known.
double full_friction_of(const SceneReport& report) {
  const bool known = report.effect && report.effect->mean_normal_force && !report.effect->opens;
  return known ? report.effect->friction_coefficient * *report.effect->mean_normal_force
               : std::numeric_limits<double>::quiet_NaN();
}

/// What is said of a point: "0.951 at 2 mm/s, 1.14 N, stick-slip".
std::string words_of_friction(const Point& point, const Scale& speed, double full_friction) {
  std::string words =
      fmt::format("{:.4g} at {:.4g} {}", point.y, point.x * speed.factor, speed.unit);
  if (std::isfinite(full_friction)) words += ", " + rounded(point.y * full_friction, "N");
  return point.words.empty() ? words : words + ", " + point.words;
}

}  // namespace

std::optional<Figure> answer_figure(const SceneReport& report) {
  const std::vector<Point> points = friction_points(report);
  const OnsetSpeeds at = onset_speeds(report);
  const bool outside = !report.reasons.empty(), curve = points.size() > 1;
  if (outside || !curve || !std::isfinite(at.drive) || !(at.drive > 0)) return std::nullopt;
  const double end = drawn_beyond * at.drive;
  const Scale scale = scale_for(end, "m/s");
  Figure figure;
  figure.name = "friction_over_speed";
  figure.title = "Friction over sliding speed";
  const double full_friction = full_friction_of(report);
  figure.caption = fmt::format(
      "Mean friction with vibration over that without{}, by simulation. Above {} "
      "vibration changes nothing.",
      std::isfinite(full_friction) ? ", " + rounded(full_friction, "N") : "", at.sign());
  figure.height = 280;
  figure.x = {"sliding speed, " + scale.unit, false, std::pair{0.0, end * scale.factor}, {}};
  figure.y = {"friction / friction without vibration", false, std::pair{0.0, 1.05}, {}};
  if (std::isfinite(full_friction)) {
    const Scale force = scale_for(full_friction, "N");
    figure.right = {"mean friction force, " + force.unit,
                    false,
                    std::pair{0.0, figure.y.range->second * full_friction * force.factor},
                    {}};
  }
  FigureSeries series;
  for (const Point& point : points)
    if (point.x <= 1.02 * end)
      series.points.push_back(
          {point.x * scale.factor, point.y, words_of_friction(point, scale, full_friction)});
  if (series.points.back().x < figure.x.range->second && series.points.back().y > 0.999)
    series.points.push_back({figure.x.range->second, 1, ""});
  figure.series.push_back(series);
  const double onset = at.drive * scale.factor;
  figure.bands = {{0, onset, "stick-slip"}};
  figure.rules.push_back(
      {onset, fmt::format("{} = {:.4g} {}", at.sign(), onset, scale.unit), false});
  if (const auto lowest = lowest_of(report)) {
    figure.series.push_back({"", Style::circles, {{0, *lowest, "lowest at rest"}}, 0});
    if (*lowest < 0.98)
      figure.rules.push_back({*lowest, rounded(*lowest, "", 3) + " at rest", true});
  }
  return figure;
}

std::optional<Figure> opening_figure(const SceneReport& report) {
  if (!report.normal_force || report.normal_force->amplitude <= report.normal_force->mean)
    return std::nullopt;
  const NormalForce& force = *report.normal_force;
  // Below an indenter both are of the pressure at its centre, in units of the mean.
  const Scale scale = report.problem->indenter ? Scale{1 / force.mean, ""}
                                               : scale_for(force.mean + force.amplitude, "N");
  const Scale time = scale_for(1 / frequency_of(report), "s");
  Figure figure;
  figure.name = "normal_force";
  figure.title = "Normal force if the contact stayed closed";
  figure.caption =
      "Over one period. Shaded: the surfaces would have to pull, so they separate and the formula "
      "does not apply.";
  figure.height = 280;
  const double period = time.factor / frequency_of(report);
  figure.x = {"time, " + time.unit, false, std::pair{0.0, period}, {}};
  figure.y = {
      report.problem->indenter ? "pressure at the centre / mean" : "normal force, " + scale.unit,
      false,
      {},
      {}};
  FigureSeries series{"", Style::line, {}, 0};
  constexpr int steps = 120;
  for (int i = 0; i <= steps; ++i)
    series.points.push_back(
        {period * i / steps,
         (force.mean + force.amplitude * std::cos(two_pi * i / steps)) * scale.factor, ""});
  figure.series.push_back(series);
  const double opens = std::acos(-force.mean / force.amplitude) / two_pi * period;
  figure.bands = {{opens, period - opens, "would pull"}};
  figure.rules = {{0, "contact opens below 0", true}};
  return figure;
}

std::optional<Figure> frequency_figure(const SceneReport& report) {
  if (report.response.points.empty()) return std::nullopt;
  std::vector<double> applies;
  for (const ResponsePoint& point : report.response.points)
    applies.push_back(point.applies ? point.velocity : std::numeric_limits<double>::quiet_NaN());
  // In the unit of the answer, if the scene has one.
  const double contact = onset_speeds(report).contact;
  const bool answered = report.reasons.empty() && contact > 0 && std::isfinite(contact);
  const Scale frequency = scale_for(frequency_of(report), "Hz"),
              velocity = scale_for(answered ? contact : middle_value(applies), "m/s");
  Figure figure = marked_frequencies(report, "critical_velocity", frequency.factor, frequency.unit);
  figure.title = "Critical speed over frequency";
  figure.caption = "All else as in the scene.";
  figure.height = 260;
  FigureSeries own{"", Style::line, {}, 0}, formula{"formula, not v*", Style::dotted, {}, 2};
  std::vector<double> shown;
  for (std::size_t i = 0; i < applies.size(); ++i) {
    const ResponsePoint& point = report.response.points[i];
    const double x = point.omega / two_pi * frequency.factor;
    if (x < figure.x.range->first / 1.05 || x > figure.x.range->second * 1.05) continue;
    own.points.push_back({x, applies[i] * velocity.factor, ""});
    formula.points.push_back({x, point.velocity * velocity.factor, ""});
    shown.push_back(point.velocity * velocity.factor);
  }
  const bool everywhere = std::all_of(report.response.points.begin(), report.response.points.end(),
                                      [](const ResponsePoint& p) { return p.applies; });
  if (!everywhere) {
    figure.caption += " Dotted: the contact does not stay closed, and the formula is not v*.";
    figure.series.push_back(formula);
  }
  figure.series.push_back(own);
  figure.y = {"v*, " + velocity.unit, true, shown_range(shown), {}};
  return figure;
}

std::optional<Figure> stiffness_figure(const SceneReport& report) {
  if (report.response.points.empty()) return std::nullopt;
  const Problem& problem = report.problem;
  const Scale frequency = scale_for(frequency_of(report), "Hz");
  std::vector<double> all;
  for (const ResponsePoint& point : report.response.points) all.push_back(point.normal);
  const char* unit = problem->indenter ? "Pa" : "N/m";
  const Scale stiffness = scale_for(middle_value(all), unit);
  Figure figure = marked_frequencies(report, "stiffness", frequency.factor, frequency.unit);
  figure.title = "Dynamic stiffness over frequency";
  figure.caption =
      "Storage stiffness, the real part, and loss stiffness, the imaginary part, of each network.";
  figure.height = 240;
  figure.y = {"dynamic stiffness, " + stiffness.unit, true, {}, {}};
  // Losses are dotted, and none of these colours has dots: grey prints tell them apart, too.
  // A loss of 0 has no place on a logarithmic axis, nor has the storage of a drive above its own
  // resonance.
  const auto add = [&](const std::string& name, int colour, const ReducedNetwork& network,
                       double times) {
    FigureSeries storage{name + " storage", Style::line, {}, colour};
    FigureSeries loss{name + " loss", Style::dotted, {}, colour};
    for (const ResponsePoint& point : report.response.points) {
      const double x = point.omega / two_pi * frequency.factor;
      if (x < figure.x.range->first / 1.05 || x > figure.x.range->second * 1.05) continue;
      const std::complex<double> k =
          times * stiffness.factor *
          dynamic_stiffness(network.reduction(), problem.values(), point.omega);
      storage.points.push_back({x, k.real(), ""});
      loss.points.push_back({x, k.imag(), ""});
    }
    for (FigureSeries* series : {&storage, &loss})
      if (std::any_of(series->points.begin(), series->points.end(),
                      [](const Point& p) { return p.y > 0; }))
        figure.series.push_back(std::move(*series));
  };
  add("normal", 0, problem->normal, 1);
  const ScaledNetwork tangential = tangential_network(problem);
  add("tangential", 1, tangential.network, tangential.factor);
  if (const ReducedNetwork* drive = problem->drive_network()) add("drive", 4, *drive, 1);
  return figure;
}

std::vector<std::pair<double, double>> answer_points(const SceneReport& report) {
  const double drive = onset_speeds(report).drive;
  std::vector<std::pair<double, double>> points;
  if (!std::isfinite(drive) || !(drive > 0)) return points;
  for (const Point& point : friction_points(report))
    if (std::isfinite(point.y) && point.x <= drawn_beyond * drive)
      points.emplace_back(point.x / drive, point.y);
  return points;
}

}  // namespace vcrit::validation::report
