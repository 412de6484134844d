// What a fit looks like: data and series, what is left between them, and the branches.
#pragma once

#include <vector>

#include "figures/figure.hpp"
#include "fit/fit.hpp"

namespace vcrit::validation::report {

/// Storage and loss; residuals; relaxation spectrum (with branches only).
std::vector<figures::Figure> fit_figures(const StiffnessTable& data, const fit::Fit& fit);

}  // namespace vcrit::validation::report
