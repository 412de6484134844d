// The result in the form that was asked for.
#pragma once

#include <vector>

#include "derivation/derivation.hpp"
#include "document/content.hpp"
#include "document/print.hpp"
#include "formula/line.hpp"

namespace vcrit::symbolic {

/// The equation for the frequencies of largest and least v*: none if there is no such frequency,
/// or if the polynomial in v* has more than `budget` terms before squaring.
std::vector<Line> extrema_lines(const Derivation& derivation, double budget);

/// Everything of the findings that the form decides; each formula in named steps is proved to be
/// that of the derivation.
void write_form(Findings& findings, const Derivation& derivation, const DocumentOptions& options);

}  // namespace vcrit::symbolic
