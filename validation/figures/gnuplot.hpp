// A figure as a script for gnuplot, data included: the pictures for papers.
#pragma once

#include <string>
#include <vector>

#include "figures/figure.hpp"

namespace vcrit::validation::figures {

/// Run by gnuplot, it writes NAME.svg and NAME.pdf, after the figure's name, to the current folder.
std::string gnuplot(const Figure& figure);

/// Run by gnuplot, it writes `file`, a PDF with a page for each figure.
std::string gnuplot_pages(const std::vector<Figure>& figures, const std::string& file);

}  // namespace vcrit::validation::figures
