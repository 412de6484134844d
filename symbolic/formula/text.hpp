// Expressions for people: one walk over the canonical form, one dialect each.
#pragma once

#include <ginac/ginac.h>

#include <string>
#include <string_view>

#include "base/numbers.hpp"
#include "formula/line.hpp"

namespace vcrit::symbolic {

struct Form;

// Hidden, it would leave numbers to the overload below: a double turns into an expression unasked.
using vcrit::to_text;
std::string to_text(const GiNaC::ex& expression);
std::string to_latex(const GiNaC::ex& expression);
/// CSS for a page with the MathML below. Roots and brackets grow with a font for mathematics;
/// letters need none.
std::string_view mathml_style();

/// Presentation MathML, <math>...</math>.
std::string to_mathml(const GiNaC::ex& expression);
std::string to_mathml(const Form& form);
/// Words for a page, with their formulas as MathML between them.
std::string to_mathml(const Prose& words);
/// The equation left = right.
std::string to_mathml(const Line& line);

}  // namespace vcrit::symbolic
