#include "report/scene_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "report/units.hpp"

namespace vcrit::validation::report {

namespace {

using figures::Figure;
using figures::Series;
using figures::Style;
using simulation::CyclePoint;

constexpr double period = 2 * std::numbers::pi;

template <class Value>
Series over_speed(const SceneReport& report, const char* name, Style style, int colour,
                  Value value) {
  Series series{name, style, {}, colour};
  for (const CurvePoint& point : report.curve)
    series.points.push_back({point.ratio, value(point), ""});
  return series;
}

double omega_of(const SceneReport& report) {
  return values_of(report.scene).at(report.scene.angular_frequency.symbol);
}

/// Over one period in time.
template <class Value>
Series over_time(const SceneReport& report, const char* name, Style style, int colour,
                 const Scale& scale, Value value) {
  const double omega = omega_of(report), per_second = scale_for(period / omega, "s").factor;
  Series series{name, style, {}, colour};
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

/// Time and the shades of stick and backward slip.
Figure cycle_figure(const SceneReport& report, const char* name, int height) {
  const double omega = omega_of(report);
  const Scale time = scale_for(period / omega, "s");
  Figure figure;
  figure.name = name;
  figure.height = height;
  figure.x = {"time, " + time.unit, false, std::pair{0.0, period / omega * time.factor}, {}};
  for (const Stretch& stretch : stretches(report.cycle->points, time.factor / omega))
    figure.bands.push_back(
        {stretch.from, stretch.to, stretch.backward ? "backward slip" : "stick"});
  return figure;
}

}  // namespace

std::string speed_axis(const SceneReport& report) {
  return report.creep_velocity > 0 ? "v₀ / (v* + creep)" : "v₀ / v*";
}

Figure friction_figure(const SceneReport& report) {
  Figure figure;
  figure.name = "friction";
  figure.title = "Friction ratio over speed";
  figure.caption =
      "Macroscopic over microscopic friction, simulated; at each speed the motion was started from "
      "sliding and from rest.";
  if (report.creep_velocity > 0)
    figure.caption += fmt::format(
        " The path creeps by {} under the mean friction force, so the far end must run that much "
        "faster than the contact point.",
        quantity(report.creep_velocity, "m/s"));
  figure.x = {speed_axis(report), false, std::pair{0.0, 1.4}, {}};
  figure.y = {"friction ratio μ macro / μ₀", false, std::pair{0.0, 1.05}, {}};
  figure.series.push_back(over_speed(report, "from sliding", Style::line, 0,
                                     [](const CurvePoint& p) { return p.from_sliding; }));
  if (!report.curve.empty() && report.curve.front().closed_form)
    figure.series.push_back(over_speed(report, "closed form", Style::dashed, 2,
                                       [](const CurvePoint& p) { return *p.closed_form; }));
  Series rest = over_speed(report, "from rest", Style::circles, 1,
                           [](const CurvePoint& p) { return p.from_rest; });
  for (std::size_t i = 0; i < rest.points.size(); ++i)
    rest.points[i].words = fmt::format("{:.4g}: {:.9f}, {}", report.curve[i].ratio,
                                       report.curve[i].from_rest, report.curve[i].regime);
  figure.series.push_back(std::move(rest));
  figure.rules.push_back({1, "pure sliding", false});
  return figure;
}

Figure force_figure(const SceneReport& report) {
  const auto force = [](const CyclePoint& point) { return point.force; };
  const auto bound = [](const CyclePoint& point) { return point.friction_bound; };
  const Scale scale = scale_of(report, "N", [&](const CyclePoint& point) {
    return std::max(std::abs(force(point)), point.friction_bound);
  });
  Figure figure = cycle_figure(report, "cycle_force", 220);
  figure.title = "Tangential force over one period";
  figure.caption =
      "Force of the network on the contact point, between the friction bounds. Shaded: no forward "
      "slip.";
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
  figure.title = "Contact velocity over one period";
  const Cycle& cycle = *report.cycle;
  figure.caption =
      fmt::format("{} of the lowest speed of pure sliding, v₀ = {}: friction ratio {:.9f}, {}.",
                  cycle.ratio == 0.5 ? "Half" : fmt::format("{:.3g}", cycle.ratio),
                  quantity(cycle.velocity, "m/s"), cycle.friction_ratio, cycle.regime);
  figure.y.title = "contact velocity, " + scale.unit;
  figure.series = {over_time(report, "", Style::line, 0, scale, velocity)};
  return figure;
}

std::vector<Stretch> stretches(const std::vector<CyclePoint>& cycle, double per_phase) {
  double fastest = 0;
  for (const auto& point : cycle) fastest = std::max(fastest, std::abs(point.contact_velocity));
  const double still = 1e-12 * fastest;
  std::vector<Stretch> result;
  bool open = false;
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    const double velocity = cycle[i].contact_velocity;
    const double from = cycle[i].phase * per_phase;
    const double to = (i + 1 < cycle.size() ? cycle[i + 1].phase : period) * per_phase;
    const bool backward = velocity < -still;
    if (velocity > still) {
      open = false;
    } else if (open && result.back().backward == backward) {
      result.back().to = to;
    } else {
      result.push_back({from, to, backward});
      open = true;
    }
  }
  return result;
}

}  // namespace vcrit::validation::report
