// A figure as a script for gnuplot, data included: the pictures for papers.
#pragma once

#include <string>

#include "figures/figure.hpp"

namespace vcrit::validation::figures {

/// Run by gnuplot, it writes NAME.svg and NAME.pdf, after the figure's name, to the current folder.
std::string gnuplot(const Figure& figure);

}  // namespace vcrit::validation::figures
