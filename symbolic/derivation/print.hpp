// Expressions for people: one walk over the canonical form, one dialect each.
#pragma once

#include <ginac/ginac.h>

#include <string>

#include "derivation/derivation.hpp"

namespace vcrit::symbolic {

enum class Format { text, latex, markdown, json };

std::string to_text(const GiNaC::ex& expression);
std::string to_latex(const GiNaC::ex& expression);
/// Presentation MathML, <math>...</math>.
std::string to_mathml(const GiNaC::ex& expression);
/// The equation left = right.
std::string to_mathml(const Line& line);

/// What `vcrit derive` prints; the same bytes in every run.
std::string print(const Scene& scene, Format format, bool with_limits);

}  // namespace vcrit::symbolic
