// Formulas of the symbolic part as plain data, for the pages.
#pragma once

#include <ginac/ginac.h>

#include <vector>

#include "compare/scene_report.hpp"
#include "formula/line.hpp"

namespace vcrit::symbolic {
struct Derivation;
struct Form;
}  // namespace vcrit::symbolic

namespace vcrit::validation {

ShownFormula formula_of(const GiNaC::ex& expression);
ShownFormula formula_of(const symbolic::Form& form);

/// What the formula of v* says in words.
std::vector<ShownFact> shown_facts(const symbolic::Derivation& derivation);

/// The shortest real formula, proved to be the derived one, where it fits a page.
ShownVelocity shown_velocity(const symbolic::Derivation& derivation);

std::vector<ShownEquation> equations_of(const std::vector<symbolic::Line>& lines);

/// The limits and special cases that the scene has.
std::vector<LimitLine> limits_of(const symbolic::Derivation& derivation);

}  // namespace vcrit::validation
