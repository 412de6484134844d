// Figures in the page.
#pragma once

#include <string>
#include <vector>

#include "figures/figure.hpp"

namespace vcrit::validation::report {

/// A figure with its caption; charts.js draws it.
std::string chart(const figures::Figure& figure);

/// The same side by side where there is room for two, each under its title.
std::string panels(const std::vector<figures::Figure>& figures);

}  // namespace vcrit::validation::report
