// Pictures of what a contact does over the period, and of friction curves beside one another.
#pragma once

#include <string>
#include <vector>

#include "compare/scene_report.hpp"
#include "figures/figure.hpp"

namespace vcrit::validation::report {

/// A colour for each motion, phase over 2 pi along x, the map's rows along y.
figures::Map contact_map(const StateMap& map);

/// mu_macro/mu0 over v0/v* of Eq. 24; the scene's own curve with dots.
figures::Figure curves_figure(const std::vector<FrictionCurve>& curves);

}  // namespace vcrit::validation::report
