// The lines of a result's form that was asked for beside the derivation.
#pragma once

#include <vector>

#include "derivation/derivation.hpp"
#include "document/print.hpp"
#include "formula/line.hpp"

namespace vcrit::symbolic {

/// The equation for the frequencies of largest and least v*: none if there is no such frequency,
/// or if the polynomial in v* has more than `budget` terms before squaring.
std::vector<Line> extrema_lines(const Derivation& derivation, double budget);

/// None for a form that is the derivation's own.
std::vector<Line> form_lines(const Derivation& derivation, const DocumentOptions& options);

}  // namespace vcrit::symbolic
