// What all ways to draw a figure at once have in common: its two scales.
#pragma once

#include "figures/axis_scale.hpp"
#include "figures/figure.hpp"

namespace vcrit::validation::figures {

struct FigureScales {
  AxisScale x, y;
};

/// With room for about so many ticks. Axes without a range hold all points that have a place.
FigureScales scales_of(const Figure& figure, int x_ticks, int y_ticks);

}  // namespace vcrit::validation::figures
