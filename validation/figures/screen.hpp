// A figure in letters, for a terminal.
#pragma once

#include <string>

#include "figures/figure.hpp"

namespace vcrit::validation::figures {

/// Lines of at most 79 letters: title, frame with series and rules, axes. Throws Bug for a map.
std::string on_screen(const Figure& figure);

}  // namespace vcrit::validation::figures
