#include "report/separation_figures.hpp"

#include <fmt/core.h>

#include "report/contact_map.hpp"

namespace vcrit::validation::report {

namespace {

using figures::Figure;

constexpr const char* speed_title = "sliding speed / v* of Eq. (24)";

}  // namespace

Figure amplitude_figure(const Separation& separation) {
  Figure figure = curves_figure(separation.curves);
  figure.name = "friction_by_amplitude";
  figure.title = "Friction ratio over speed, by amplitude";
  figure.caption =
      "A curve for each amplitude, over speed in units of Eq. (24) at that amplitude. "
      "Dots: this scene.";
  return figure;
}

Figure state_figure(const Separation& separation) {
  Figure figure;
  figure.name = "contact_state";
  figure.title = "What the contact does over one period, by speed";
  figure.caption =
      "The vibration presses most at phase 0 and least at half a period. One row for each speed.";
  figure.x = {"phase ωt / 2π", false, std::pair{0.0, 1.0}, {}};
  figure.y = {speed_title, false, std::pair{0.0, 1.2}, {}};
  figure.map = contact_map(separation.map);
  return figure;
}

}  // namespace vcrit::validation::report
