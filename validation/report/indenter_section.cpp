#include "report/indenter_section.hpp"

#include <fmt/core.h>

#include "report/chart.hpp"
#include "report/contact_map.hpp"
#include "report/html.hpp"
#include "report/units.hpp"

namespace vcrit::validation::report {

namespace {

using figures::Figure;

std::string indenter_words(const Indented& indented) {
  const std::string text = fmt::format(
      "By the method of dimensionality reduction the contact is a row of independent ones, each "
      "with "
      "its own indentation. Its radius is {} under the mean indentation and {} at most; the mean "
      "normal force is {}. ",
      quantity(indented.radius, "m"), quantity(indented.edge, "m"),
      quantity(indented.normal_force, "N"));
  if (indented.closed_form)
    return text +
           "Stiffnesses along and across have one ratio everywhere, so that Eq. 24 gives one v* "
           "for all of them, whatever the shape; those that part slide from less on.";
  return text + "Everywhere the surfaces part, and meet too late for Eq. 24; by simulation v* = " +
         quantity(indented.critical_velocity, "m/s", 5) + ".";
}

Figure indenter_amplitude_figure(const Indented& indented) {
  Figure figure = curves_figure(indented.amplitudes);
  figure.name = "indenter_by_amplitude";
  figure.title = "Friction ratio over speed, by amplitude";
  figure.caption = "The indenter of this scene. Thick dots: its amplitude.";
  return figure;
}

Figure indenter_shape_figure(const Indented& indented) {
  Figure figure = curves_figure(indented.shapes);
  figure.name = "indenter_by_shape";
  figure.title = "Friction ratio over speed, by shape";
  figure.caption =
      "At the same amplitude over indentation; of shapes like rⁿ nothing but n matters. Thick "
      "dots: "
      "this scene.";
  return figure;
}

Figure indenter_state_figure(const Indented& indented) {
  Figure figure;
  figure.name = "contact_state";
  figure.title = "What the contact does over its width and one period";
  figure.caption = fmt::format(
      "At {:.3g} of v*. From the centre to the largest radius of contact; the indentation is "
      "largest "
      "at phase 0 and least at half a period.",
      indented.map_ratio);
  figure.x = {"phase ωt / 2π", false, std::pair{0.0, 1.0}, {}};
  figure.y = {"distance from the centre / largest contact radius", false, std::pair{0.0, 1.0}, {}};
  figure.map = contact_map(indented.map);
  return figure;
}

}  // namespace

std::vector<Figure> indenter_figures(const Indented& indented) {
  return {indenter_amplitude_figure(indented), indenter_shape_figure(indented),
          indenter_state_figure(indented)};
}

std::string indenter_section(const SceneReport& report) {
  if (!report.indented) return {};
  std::string html =
      "<h3>Below the indenter</h3>\n<p>" + escape(indenter_words(*report.indented)) + "</p>\n";
  for (const Figure& figure : indenter_figures(*report.indented)) html += chart(figure);
  return html;
}

}  // namespace vcrit::validation::report
