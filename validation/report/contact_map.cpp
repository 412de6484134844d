#include "report/contact_map.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "base/constants.hpp"
#include "base/errors.hpp"

namespace vcrit::validation::report {

namespace {

using figures::Figure;
using figures::FigureSeries;
using figures::Style;
using simulation::Motion;

// Its place among the classes of a map.
double class_of(Motion motion) {
  switch (motion) {
    case Motion::stick:
      return 0;
    case Motion::slip:
      return 1;
    case Motion::separated:
      return 2;
    case Motion::backslip:
      return 3;
  }
  throw Bug("a motion without a class");
}

const char* class_words(Motion motion) {
  switch (motion) {
    case Motion::stick:
      return "sticks";
    case Motion::slip:
      return "slides";
    case Motion::separated:
      return "open";
    case Motion::backslip:
      return "slides back";
  }
  throw Bug("a motion without words");
}

}  // namespace

figures::Map contact_map(const StateMap& states) {
  figures::Map map;
  map.value = {"contact point", false, {}, {}};
  for (const Motion motion : {Motion::stick, Motion::slip, Motion::separated, Motion::backslip})
    if (std::find(states.motions.begin(), states.motions.end(), motion) != states.motions.end())
      map.value.ticks.emplace_back(class_of(motion), class_words(motion));
  for (const double phase : states.phases) map.x.push_back(phase / (two_pi));
  map.y = states.rows;
  for (const auto& motion : states.motions)
    map.values.push_back(motion ? class_of(*motion) : std::numeric_limits<double>::quiet_NaN());
  return map;
}

Figure curves_figure(const std::vector<FrictionCurve>& curves) {
  Figure figure;
  figure.x = {"sliding speed / v* of Eq. (24)", false, std::pair{0.0, 1.2}, {}};
  figure.y = {"friction / friction without vibration", false, std::pair{0.0, 1.05}, {}};
  int colour = 0;
  for (const FrictionCurve& curve : curves) {
    FigureSeries series{curve.name, Style::line, {}, colour++};
    for (std::size_t i = 0; i < curve.ratios.size(); ++i)
      series.points.push_back({curve.ratios[i], curve.friction[i],
                               fmt::format("{}: {:.9f}", curve.name, curve.friction[i])});
    if (curve.own) {
      FigureSeries own = series;
      own.style = Style::dots;
      figure.series.push_back(std::move(own));
    }
    figure.series.push_back(std::move(series));
  }
  return figure;
}

}  // namespace vcrit::validation::report
