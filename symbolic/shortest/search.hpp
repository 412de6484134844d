// The shortest of many ways to write an expression.
#pragma once

#include <cstddef>
#include <vector>

#include "shortest/expressions.hpp"

namespace vcrit::symbolic::shortest {

/// What a search may cost; the same in every run, as no clock is asked. What was found until then
/// is taken.
struct SearchEffort {
  std::size_t expanded = 0;  ///< expressions whose moves are tried
  std::size_t work = 0;      ///< as the expressions count it
};

int operations(const Expressions& all, const Ex& whole);

/// Expressions that are written one below the other, what they share once: definitions, then what
/// they are for.
using ExLines = std::vector<Ex>;

int operations(const Expressions& all, const ExLines& lines);

/// The shortest of the formulas, which are equal, and of all that moves within their expressions
/// lead to within the effort. Of several the one found first.
ExLines shortest_of(Expressions& all, const std::vector<ExLines>& starts,
                    const SearchEffort& effort);
/// The same of formulas without definitions.
Ex shortest_of(Expressions& all, const std::vector<Ex>& starts, const SearchEffort& effort);

}  // namespace vcrit::symbolic::shortest
