#include "report/scene_figures.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "accuracy/pictures.hpp"
#include "report/answer_figures.hpp"
#include "report/cycle_figures.hpp"
#include "report/indenter_figures.hpp"
#include "report/onset_speeds.hpp"
#include "report/separation_figures.hpp"
#include "report/units.hpp"

namespace vcrit::validation::report {

namespace {

using figures::Figure;
using figures::FigureSeries;
using figures::Style;

template <class Value>
FigureSeries over_speed(const SceneReport& report, const char* name, Style style, int colour,
                        Value value) {
  FigureSeries series{name, style, {}, colour};
  for (const ComparedPoint& point : report.curve)
    series.points.push_back({point.ratio, value(point), ""});
  return series;
}

template <class Value>
FigureSeries by_method(const MethodCurve& method, std::size_t number, Value value) {
  static constexpr std::array colours{0, 1, 3, 4};
  FigureSeries series{
      method.method, figures::shape_of(number), {}, colours.at(number % colours.size())};
  for (const MethodPoint& point : method.points)
    if (point.reason.empty())
      series.points.push_back({point.ratio, value(point),
                               fmt::format("{} at {}: {:.12f}, {:.1e} off", method.method,
                                           point.ratio, point.friction_ratio, point.difference)});
  return series;
}

}  // namespace

std::vector<Figure> scene_figures(const SceneContents& contents) {
  const SceneReport& report = contents.report;
  std::vector<Figure> all;
  for (const std::optional<Figure>& figure : {answer_figure(report), opening_figure(report),
                                              frequency_figure(report), stiffness_figure(report)})
    if (figure) all.push_back(*figure);
  if (!report.curve.empty()) all.push_back(friction_figure(report));
  if (!report.methods.empty()) all.push_back(residual_figure(report));
  if (report.cycle) {
    all.push_back(force_figure(report));
    all.push_back(velocity_figure(report));
  }
  if (report.separation) {
    if (!report.separation->curves.empty()) all.push_back(amplitude_figure(*report.separation));
    all.push_back(state_figure(*report.separation));
  }
  if (report.indented)
    for (Figure& figure : indenter_figures(*report.indented)) all.push_back(std::move(figure));
  if (contents.accuracy)
    for (Figure& figure : accuracy::pictures(*contents.accuracy)) all.push_back(std::move(figure));
  return all;
}

std::string speed_axis(const SceneReport& report) {
  return "v₀ / " + onset_speeds(report).factor();
}

Figure friction_figure(const SceneReport& report) {
  Figure figure;
  figure.name = "friction";
  figure.title = "Friction ratio over speed";
  figure.caption =
      "Mean friction with vibration over that without. At each speed the simulation starts from "
      "sliding and from rest.";
  if (report.creep_velocity > 0)
    figure.caption += fmt::format(
        " The path creeps by {} under the mean friction force: the drive must run that much faster "
        "than the contact point.",
        quantity(report.creep_velocity, "m/s"));
  figure.x = {speed_axis(report), false, std::pair{0.0, 1.4}, {}};
  figure.y = {"friction ratio μ/μ₀", false, std::pair{0.0, 1.05}, {}};
  figure.series.push_back(over_speed(report, "from sliding", Style::line, 0,
                                     [](const ComparedPoint& p) { return p.from_sliding; }));
  if (!report.curve.empty() && report.curve.front().closed_form)
    figure.series.push_back(over_speed(report, "closed form", Style::dashed, 2,
                                       [](const ComparedPoint& p) { return *p.closed_form; }));
  FigureSeries rest = over_speed(report, "from rest", Style::circles, 1,
                                 [](const ComparedPoint& p) { return p.from_rest; });
  for (std::size_t i = 0; i < rest.points.size(); ++i)
    rest.points[i].words =
        fmt::format("{:.4g}: {:.9f}, {}", report.curve[i].ratio, report.curve[i].from_rest,
                    motion_words(report.curve[i].regime));
  figure.series.push_back(std::move(rest));
  std::size_t number = 1;  // 0 is the exact one
  for (const MethodCurve& method : report.methods)
    figure.series.push_back(
        by_method(method, number++, [](const MethodPoint& point) { return point.friction_ratio; }));
  figure.rules.push_back({1, "v*", false});
  return figure;
}

Figure residual_figure(const SceneReport& report) {
  Figure figure;
  figure.name = "friction_residual";
  figure.height = 220;
  figure.title = "Difference of the other methods from the exact one";
  figure.caption = "Each with its usual setting. A difference of 0 stands at 10⁻¹⁷:";
  figure.x = {speed_axis(report), false, std::pair{0.0, 1.4}, {}};
  figure.y = {"|difference| of the friction ratio", true, std::pair{1e-17, 1.0}, {}};
  std::size_t number = 1;
  for (const MethodCurve& method : report.methods) {
    figure.series.push_back(by_method(method, number++, [](const MethodPoint& point) {
      return std::max(point.difference, 1e-17);
    }));
    figure.caption += fmt::format(" {} {},", method.method, method.setting);
  }
  figure.caption.back() = '.';
  return figure;
}

}  // namespace vcrit::validation::report
