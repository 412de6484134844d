// How wide LaTeX sets a formula, in points, estimated from the widths of Computer Modern at 10 pt:
// enough to know where a line has to be broken. Glyphs are those of cmmi10 and cmr10 (their .tfm
// files, rounded up), spaces those of plain TeX, delimiters as if they were as large as they come.
#pragma once

#include "formula/form.hpp"
#include "formula/prose.hpp"

namespace vcrit::symbolic {

/// Of a displayed formula, in pt.
double width_of(const Form& form);
double width_of(const Signed& expression);
double width_of(const Statement& statement);

/// Between two terms: a sign with its spaces.
inline constexpr double width_of_sign = 12.3;
/// An equals sign with its spaces.
inline constexpr double width_of_relation = 13.4;

/// The text of an article on A4 paper, \textwidth in pt, without what an estimate may lack.
inline constexpr double text_width = 345, safe_text_width = 0.97 * text_width;

}  // namespace vcrit::symbolic
