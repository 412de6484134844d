// How much v* answers to one parameter, by differentiating Eq. 24 along with its evaluation.
#pragma once

#include "problem/problem.hpp"

namespace vcrit {

/// Throws InputError for a symbol that neither has a value in the problem nor may be set.
void check_symbol(const Problem& problem, const Symbol& symbol);

/// (p/v*) dv*/dp, without unit, for any symbol p of the scene that has a value (0 where v* does not
/// depend on it). In doubles: near a resonance or antiresonance it loses as many digits as v*
/// there; of drives that hold masses as good as v* itself. Throws ModelError where v* is 0 or
/// infinite, and for omega at a row of a measured drive, where the table has a kink.
double log_derivative(const Problem& problem, const Symbol& symbol);

}  // namespace vcrit
