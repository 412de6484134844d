#include "report/charts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/numbers.hpp"
#include "report/units.hpp"

namespace vcrit::validation::report {

namespace {

using nlohmann::ordered_json;

// Legible on white and on near-black alike.
const char* const accent = "#2090ad";
const char* const second = "#d07a28";
const char* const neutral = "#8a8f98";
constexpr double period = 2 * std::numbers::pi;

/// Enough digits for a picture; the exact ones are in the tables and in report.json.
ordered_json drawn(double value) {
  if (!std::isfinite(value)) return nullptr;
  return to_double(fmt::format("{:.7g}", value)).value();
}

ordered_json chart(int height, ordered_json data) {
  return {{"width", "container"},
          {"height", height},
          {"background", nullptr},
          {"data", {{"values", std::move(data)}}},
          {"layer", ordered_json::array()}};
}

ordered_json axis(const char* field, const std::string& title) {
  return {{"field", field}, {"type", "quantitative"}, {"title", title}};
}

/// A legend entry without a field of its own.
ordered_json series(const char* name) { return {{"datum", name}, {"type", "nominal"}}; }

ordered_json legend(ordered_json names, ordered_json colours) {
  return {{"datum", names.front()},
          {"type", "nominal"},
          {"scale", {{"domain", names}, {"range", std::move(colours)}}},
          {"legend", {{"title", nullptr}, {"orient", "top"}}}};
}

ordered_json mark(const char* type, ordered_json more = ordered_json::object()) {
  more["type"] = type;
  return more;
}

/// A vertical line at x, with words at its foot.
void add_rule(ordered_json& spec, double x, const std::string& words) {
  const ordered_json data{{"values", {{{"x", x}}}}};
  spec["layer"].push_back({{"data", data},
                           {"mark", mark("rule", {{"color", neutral}, {"strokeDash", {4, 3}}})},
                           {"encoding", {{"x", {{"field", "x"}, {"type", "quantitative"}}}}}});
  if (words.empty()) return;
  spec["layer"].push_back(
      {{"data", data},
       {"mark",
        mark("text", {{"align", "left"}, {"dx", 5}, {"baseline", "bottom"}, {"text", words}})},
       {"encoding",
        {{"x", {{"field", "x"}, {"type", "quantitative"}}}, {"y", {{"datum", 0.02}}}}}});
}

ordered_json tooltip(const std::string& speed) {
  return {{{"field", "x"}, {"type", "quantitative"}, {"title", speed}},
          {{"field", "sliding"},
           {"type", "quantitative"},
           {"title", "friction ratio"},
           {"format", ".7f"}},
          {{"field", "rest"},
           {"type", "quantitative"},
           {"title", "started from rest"},
           {"format", ".7f"}},
          {{"field", "regime"}, {"type", "nominal"}, {"title", "motion"}}};
}

ordered_json curve_data(const SceneReport& report) {
  ordered_json rows = ordered_json::array();
  for (const CurvePoint& point : report.curve) {
    ordered_json row{{"x", point.ratio},
                     {"sliding", drawn(point.from_sliding)},
                     {"rest", drawn(point.from_rest)},
                     {"regime", point.regime}};
    if (point.closed_form) row["closed"] = drawn(*point.closed_form);
    rows.push_back(std::move(row));
  }
  return rows;
}

struct Names {
  ordered_json names, colours;
};

Names curve_names(bool closed_form) {
  Names names{{"from sliding", "from rest"}, {accent, second}};
  if (closed_form) {
    names.names.push_back("closed form");
    names.colours.push_back(neutral);
  }
  return names;
}

/// Time over one period and, in `field`, one or two things at each instant, in one unit.
struct Trace {
  ordered_json rows;
  Scale time, value;
};

template <class Read>
Trace trace(const SceneReport& report, const std::string& unit, Read read) {
  const double omega = values_of(report.scene).at(report.scene.angular_frequency.symbol);
  double largest = 0;
  for (const auto& point : report.cycle->points)
    for (const double value : read(point)) largest = std::max(largest, std::abs(value));
  Trace result{ordered_json::array(), scale_for(period / omega, "s"), scale_for(largest, unit)};
  for (const auto& point : report.cycle->points) {
    const auto values = read(point);
    ordered_json row{{"t", drawn(point.phase / omega * result.time.factor)},
                     {"a", drawn(values.front() * result.value.factor)}};
    if (values.size() > 1) {
      row["b"] = drawn(values[1] * result.value.factor);
      row["c"] = drawn(-values[1] * result.value.factor);
    }
    result.rows.push_back(std::move(row));
  }
  return result;
}

void shade(ordered_json& spec, const SceneReport& report, const Trace& trace) {
  const double omega = values_of(report.scene).at(report.scene.angular_frequency.symbol);
  ordered_json rows = ordered_json::array();
  for (const Stretch& stretch : stretches(report.cycle->points, trace.time.factor / omega))
    rows.push_back({{"from", stretch.from},
                    {"to", stretch.to},
                    {"motion", stretch.backward ? "backward slip" : "stick"}});
  if (rows.empty()) return;
  spec["layer"].push_back(
      {{"data", {{"values", std::move(rows)}}},
       {"mark", mark("rect", {{"color", second}, {"opacity", 0.16}, {"clip", true}})},
       {"encoding",
        {{"x", {{"field", "from"}, {"type", "quantitative"}}},
         {"x2", {{"field", "to"}}},
         {"tooltip", {{"field", "motion"}, {"type", "nominal"}}}}}});
}

ordered_json time_axis(const SceneReport& report, const Trace& trace) {
  const double omega = values_of(report.scene).at(report.scene.angular_frequency.symbol);
  ordered_json x = axis("t", "time, " + trace.time.unit);
  x["scale"] = {{"domain", {0, period / omega * trace.time.factor}}, {"nice", false}};
  return x;
}

ordered_json curve_layer(const char* field, ordered_json mark, ordered_json x,
                         const std::string& title, ordered_json colour) {
  return {
      {"mark", std::move(mark)},
      {"encoding", {{"x", std::move(x)}, {"y", axis(field, title)}, {"color", std::move(colour)}}}};
}

}  // namespace

std::string speed_axis(const SceneReport& report) {
  return report.creep_velocity > 0 ? "v₀ / (v* + creep)" : "v₀ / v*";
}

ordered_json friction_chart(const SceneReport& report) {
  ordered_json spec = chart(320, curve_data(report));
  const bool closed_form = !report.curve.empty() && report.curve.front().closed_form.has_value();
  const Names names = curve_names(closed_form);
  const std::string title = "friction ratio  μ macro / μ₀";
  ordered_json x = axis("x", speed_axis(report));
  x["scale"] = {{"domain", {0, 1.4}}, {"nice", false}};
  add_rule(spec, 1, "pure sliding");
  auto& layers = spec["layer"];
  layers.push_back(curve_layer("sliding", mark("line", {{"strokeWidth", 2.2}}), x, title,
                               legend(names.names, names.colours)));
  layers.back()["encoding"]["y"]["scale"] = {{"domain", {0, 1.05}}, {"nice", false}};
  if (closed_form)
    layers.push_back(curve_layer("closed", mark("line", {{"strokeDash", {6, 4}}}), x, title,
                                 series("closed form")));
  layers.push_back(curve_layer("rest", mark("point", {{"size", 34}, {"filled", false}}), x, title,
                               series("from rest")));
  layers.back()["encoding"]["tooltip"] = tooltip(speed_axis(report));
  return spec;
}

ordered_json force_chart(const SceneReport& report) {
  const Trace forces = trace(report, "N", [](const simulation::CyclePoint& point) {
    return std::array{point.force, point.friction_bound};
  });
  ordered_json spec = chart(220, forces.rows);
  shade(spec, report, forces);
  const ordered_json x = time_axis(report, forces);
  const std::string title = "tangential force, " + forces.value.unit;
  const ordered_json dashed = mark("line", {{"strokeDash", {5, 4}}, {"strokeWidth", 1.3}});
  auto& layers = spec["layer"];
  layers.push_back(curve_layer("b", dashed, x, title, series("friction bound ±μ₀ Fₙ")));
  layers.push_back(curve_layer("c", dashed, x, title, series("friction bound ±μ₀ Fₙ")));
  layers.push_back(curve_layer("a", mark("line", {{"strokeWidth", 2.2}}), x, title,
                               legend({"force", "friction bound ±μ₀ Fₙ"}, {accent, neutral})));
  return spec;
}

ordered_json velocity_chart(const SceneReport& report) {
  const Trace velocity = trace(report, "m/s", [](const simulation::CyclePoint& point) {
    return std::array{point.contact_velocity};
  });
  ordered_json spec = chart(180, velocity.rows);
  shade(spec, report, velocity);
  spec["layer"].push_back(
      curve_layer("a", mark("line", {{"strokeWidth", 2.2}}), time_axis(report, velocity),
                  "contact velocity, " + velocity.value.unit, {{"value", accent}}));
  return spec;
}

std::vector<Stretch> stretches(const std::vector<simulation::CyclePoint>& cycle, double per_phase) {
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
