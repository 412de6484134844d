// The tables of the page about extremes.
#pragma once

#include <string>

#include "extremes/contents.hpp"

namespace vcrit::validation::report {

/// Losses of each family in one region.
std::string loss_table(const extremes::Extremes& extremes, const std::string& key);

/// The worst inputs in one region, folded; empty where nothing is lost.
std::string worst_table(const extremes::Extremes& extremes, const std::string& key);

std::string simulator_table(const extremes::Extremes& extremes);

/// What the simulator answered wrongly or not at all.
std::string silence_table(const extremes::Extremes& extremes);

}  // namespace vcrit::validation::report
