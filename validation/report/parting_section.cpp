#include "report/parting_section.hpp"

#include <fmt/core.h>

#include <cmath>

#include "report/chart.hpp"
#include "report/contact_map.hpp"
#include "report/equations.hpp"
#include "report/html.hpp"
#include "report/units.hpp"

namespace vcrit::validation::report {

namespace {

using figures::Figure;

constexpr const char* speed_title = "v₀ / v* of Eq. 24";

std::string parting_words(const SceneReport& report) {
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

std::string derivation_steps(const Parting& parting) {
  std::string steps;
  for (const Equation& line : parting.derivation)
    steps += fmt::format("<li><p>{}</p>{}</li>\n", escape(line.words), equation(line));
  return steps.empty() ? "" : "<ol>\n" + steps + "</ol>\n";
}

}  // namespace

Figure amplitude_figure(const Parting& parting) {
  Figure figure = curves_figure(parting.curves);
  figure.name = "friction_by_amplitude";
  figure.title = "Friction ratio over speed, by amplitude";
  figure.caption =
      "Each amplitude over that at which the surfaces begin to part; the speed over Eq. 24 at that "
      "amplitude. Thick dots: this scene.";
  return figure;
}

Figure state_figure(const Parting& parting) {
  Figure figure;
  figure.name = "contact_state";
  figure.title = "What the contact does over one period, by speed";
  figure.caption =
      "The indentation is largest at phase 0 and least at half a period. One row for each speed.";
  figure.x = {"phase ωt / 2π", false, std::pair{0.0, 1.0}, {}};
  figure.y = {speed_title, false, std::pair{0.0, 1.2}, {}};
  figure.map = contact_map(parting.map);
  return figure;
}

std::string parting_section(const SceneReport& report) {
  if (!report.parting) return {};
  const Parting& parting = *report.parting;
  std::string html = "<h3>Surfaces that part</h3>\n<p>" + escape(parting_words(report)) + "</p>\n" +
                     derivation_steps(parting);
  if (!parting.curves.empty()) html += chart(amplitude_figure(parting));
  return html + chart(state_figure(parting));
}

}  // namespace vcrit::validation::report
