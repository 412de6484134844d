#include "report/cycle_figures.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"
#include "report/onset_speeds.hpp"
#include "report/stretches.hpp"
#include "report/units.hpp"

namespace vcrit::validation::report {

namespace {

using figures::Figure;
using figures::FigureSeries;
using figures::Style;
using simulation::CyclePoint;

double omega_of_cycle(const SceneReport& report) {
  return report.problem.values().at(report.problem->angular_frequency.symbol);
}

/// Over one period in time.
template <class Value>
FigureSeries over_time(const SceneReport& report, const char* name, Style style, int colour,
                       const Scale& scale, Value value) {
  const double omega = omega_of_cycle(report), per_second = scale_for(two_pi / omega, "s").factor;
  FigureSeries series{name, style, {}, colour};
  for (const CyclePoint& point : report.cycle->points)
    series.points.push_back({point.phase / omega * per_second, value(point) * scale.factor, ""});
  return series;
}

template <class Value>
Scale scale_of(const SceneReport& report, const char* unit, Value value) {
  double largest = 0;
  for (const CyclePoint& point : report.cycle->points)
    largest = std::max(largest, std::abs(value(point)));
  return scale_for(largest, unit);
}

double length_of(const MotionStretch& stretch) { return stretch.to - stretch.from; }

/// All of the period together: one that goes on over its end is drawn as two.
std::string sticking_words(const std::vector<MotionStretch>& all, double period) {
  double sum = 0;
  for (const MotionStretch& stretch : all)
    if (!stretch.backward) sum += length_of(stretch);
  return fmt::format("sticks {:.0f} %", 100 * sum / period);
}

auto longest_sticking(const std::vector<MotionStretch>& all) {
  return std::max_element(
      all.begin(), all.end(), [](const MotionStretch& a, const MotionStretch& b) {
        return (a.backward ? 0 : length_of(a)) < (b.backward ? 0 : length_of(b));
      });
}

/// Time and the shades of stick and backward slip.
Figure cycle_figure(const SceneReport& report, const char* name, int height) {
  const double omega = omega_of_cycle(report);
  const Scale time = scale_for(two_pi / omega, "s");
  Figure figure;
  figure.name = name;
  figure.height = height;
  figure.x = {"time, " + time.unit, false, std::pair{0.0, two_pi / omega * time.factor}, {}};
  const std::vector<MotionStretch> all = stretches(*report.cycle, time.factor / omega);
  const std::string sticks = sticking_words(all, figure.x.range->second);
  const auto longest = longest_sticking(all);
  for (auto stretch = all.begin(); stretch != all.end(); ++stretch)
    figure.bands.push_back(
        {stretch->from, stretch->to,
         stretch->backward ? "reverse slip" : (stretch == longest ? sticks : std::string())});
  return figure;
}

/// ", half of v*"; nothing where v* is infinite.
std::string share_of_onset(const SceneReport& report) {
  const double ratio = report.cycle->ratio;
  if (ratio == 0) return {};
  return fmt::format(", {} of {}", ratio == 0.5 ? "half" : fmt::format("{:.3g}", ratio),
                     onset_speeds(report).factor());
}

}  // namespace

Figure force_figure(const SceneReport& report) {
  const auto force = [](const CyclePoint& point) { return point.force; };
  const auto bound = [](const CyclePoint& point) { return point.friction_bound; };
  const Scale scale = scale_of(report, "N", [&](const CyclePoint& point) {
    return std::max(std::abs(force(point)), point.friction_bound);
  });
  Figure figure = cycle_figure(report, "cycle_force", 220);
  figure.title = "Tangential force over one period";
  figure.caption = "Force on the contact point, between the bounds that friction sets.";
  figure.y.title = "tangential force, " + scale.unit;
  const char* const name = "friction bound ±μ₀ Fₙ";
  figure.series = {over_time(report, name, Style::dashed, 2, scale, bound),
                   over_time(report, name, Style::dashed, 2, scale,
                             [&](const CyclePoint& point) { return -bound(point); }),
                   over_time(report, "force", Style::line, 0, scale, force)};
  return figure;
}

Figure velocity_figure(const SceneReport& report) {
  const auto velocity = [](const CyclePoint& point) { return point.contact_velocity; };
  const Scale scale = scale_of(report, "m/s", velocity);
  Figure figure = cycle_figure(report, "cycle_velocity", 180);
  figure.title = "Speed of the contact point over one period";
  const Cycle& cycle = *report.cycle;
  figure.caption =
      fmt::format("At {}{}: friction ratio {:.4g}, {}.", quantity(cycle.velocity, "m/s", 4),
                  share_of_onset(report), cycle.friction_ratio, motion_words(cycle.regime));
  figure.y.title = "contact speed, " + scale.unit;
  figure.series = {over_time(report, "", Style::line, 0, scale, velocity)};
  return figure;
}

}  // namespace vcrit::validation::report
