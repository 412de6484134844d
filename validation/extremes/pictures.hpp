// The pictures of extremes: maps of the worst family in each cell, and error over the distance
// from resonance.
#pragma once

#include <vector>

#include "extremes/contents.hpp"
#include "figures/figure.hpp"

namespace vcrit::validation::extremes {

/// Of the regions that are maps: a figure for each of three ways and for the simulator.
std::vector<figures::Figure> maps(const Extremes& extremes, const std::string& region);

/// Of "resonance" or "antiresonance": one for an undamped and one for a damped drive.
std::vector<figures::Figure> approach_pictures(const Extremes& extremes, const std::string& key);

/// All of them.
std::vector<figures::Figure> pictures(const Extremes& extremes);

}  // namespace vcrit::validation::extremes
