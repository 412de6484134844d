// Figures as one picture that stands alone: for papers, README files, and where no script runs.
#pragma once

#include <string>
#include <vector>

#include "figures/figure.hpp"

namespace vcrit::validation::figures {

/// SVG of 680 pixels in width, the figures one below the other. Figures have lines and points:
/// throws Bug for a map and for bars.
std::string svg(const std::vector<Figure>& figures);

/// One of them without its title, as an element of a page whose style says the colours in the dark.
/// Throws likewise.
std::string still(const Figure& figure);

}  // namespace vcrit::validation::figures
