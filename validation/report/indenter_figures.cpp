#include "report/indenter_figures.hpp"

#include <fmt/core.h>

#include "report/contact_map.hpp"

namespace vcrit::validation::report {

namespace {

using figures::Figure;

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
      "All at the same ratio of amplitude to indentation. For a shape rⁿ only n matters. Thick "
      "dots: this scene.";
  return figure;
}

Figure indenter_state_figure(const Indented& indented) {
  Figure figure;
  figure.name = "contact_state";
  figure.title = "What the contact does over its width and one period";
  figure.caption = fmt::format(
      "At {:.3g} of v*, from the centre (0) to the largest radius of contact (1). The indentation "
      "is largest at phase 0 and least at half a period.",
      indented.map_ratio);
  figure.x = {"phase ωt / 2π", false, std::pair{0.0, 1.0}, {}};
  figure.y = {"distance from the centre", false, std::pair{0.0, 1.0}, {}};
  figure.map = contact_map(indented.map);
  return figure;
}

}  // namespace

std::vector<Figure> indenter_figures(const Indented& indented) {
  return {indenter_amplitude_figure(indented), indenter_shape_figure(indented),
          indenter_state_figure(indented)};
}

}  // namespace vcrit::validation::report
