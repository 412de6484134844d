#include "report/parting_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "report/chart.hpp"
#include "report/equations.hpp"
#include "report/html.hpp"
#include "report/units.hpp"

namespace vcrit::validation::report {

namespace {

using figures::Figure;
using figures::Series;
using figures::Style;
using simulation::Motion;

constexpr const char* speed = "v₀ / v* of Eq. 24";

std::string words_of(const SceneReport& report) {
  const Parting& parting = *report.parting;
  std::string text = fmt::format(
      "The surfaces may part: the normal force is the reaction of the contact or 0. They "
      "part where the amplitude is above {:.4g} of the indentation; ",
      parting.border);
  text += parting.opens ? "in this scene they do, once in each period at least. "
                        : "in this scene they do not. ";
  if (parting.closed_form) return text + "Eq. 24 gives v* all the same.";
  if (std::isinf(parting.critical_velocity))
    return text +
           "The normal force jumps where they meet and the tangential one cannot, so that the "
           "contact sticks for a moment however fast it is drawn: there is no v*.";
  return text + "Eq. 24 does not hold then; by simulation v* = " +
         quantity(parting.critical_velocity, "m/s", 5) + ".";
}

std::string derivation(const Parting& parting) {
  std::string steps;
  for (const Equation& line : parting.derivation)
    steps += fmt::format("<li><p>{}</p>{}</li>\n", escape(line.words), equation(line));
  return steps.empty() ? "" : "<ol>\n" + steps + "</ol>\n";
}

// Its place among the classes of a map.
double class_of(Motion motion) {
  switch (motion) {
    case Motion::stick:
      return 0;
    case Motion::slip:
      return 1;
    case Motion::apart:
      return 2;
    case Motion::backslip:
      return 3;
  }
  throw Bug("a motion without a class");
}

}  // namespace

Figure amplitude_figure(const Parting& parting) {
  Figure figure;
  figure.name = "friction_by_amplitude";
  figure.title = "Friction ratio over speed, by amplitude";
  figure.caption =
      "Each amplitude over that at which the surfaces begin to part; the speed over Eq. 24 at that "
      "amplitude. Thick dots: this scene.";
  figure.x = {speed, false, std::pair{0.0, 1.2}, {}};
  figure.y = {"friction ratio μ macro / μ₀", false, std::pair{0.0, 1.05}, {}};
  int colour = 0;
  for (const FrictionCurve& curve : parting.curves) {
    Series series{curve.name, Style::line, {}, colour++};
    for (std::size_t i = 0; i < curve.ratios.size(); ++i)
      series.points.push_back({curve.ratios[i], curve.friction[i],
                               fmt::format("{}: {:.9f}", curve.name, curve.friction[i])});
    if (curve.own) {
      Series own = series;
      own.style = Style::dots;
      figure.series.push_back(std::move(own));
    }
    figure.series.push_back(std::move(series));
  }
  return figure;
}

Figure state_figure(const Parting& parting) {
  Figure figure;
  figure.name = "contact_state";
  figure.title = "What the contact does over one period, by speed";
  figure.caption =
      "The indentation is largest at phase 0 and least at half a period. One row for each speed.";
  figure.x = {"phase ωt / 2π", false, std::pair{0.0, 1.0}, {}};
  figure.y = {speed, false, std::pair{0.0, 1.2}, {}};
  figures::Map map;
  map.value = {"contact", false, {}, {}};
  for (const Motion motion : {Motion::stick, Motion::slip, Motion::apart, Motion::backslip})
    if (std::find(parting.map.motions.begin(), parting.map.motions.end(), motion) !=
        parting.map.motions.end())
      map.value.ticks.emplace_back(class_of(motion), to_text(motion));
  for (const double phase : parting.map.phases) map.x.push_back(phase / (2 * std::numbers::pi));
  map.y = parting.map.rows;
  for (const Motion motion : parting.map.motions) map.values.push_back(class_of(motion));
  figure.map = std::move(map);
  return figure;
}

std::string parting_section(const SceneReport& report) {
  if (!report.parting) return {};
  const Parting& parting = *report.parting;
  std::string html = "<h3>Surfaces that part</h3>\n<p>" + escape(words_of(report)) + "</p>\n" +
                     derivation(parting);
  if (!parting.curves.empty()) html += chart(amplitude_figure(parting));
  return html + chart(state_figure(parting));
}

}  // namespace vcrit::validation::report
