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

/// The shortest of the expressions, which are equal, and of all that moves lead to within the
/// effort. Of several the one found first.
Ex shortest_of(Expressions& all, const std::vector<Ex>& starts, const SearchEffort& effort);

}  // namespace vcrit::symbolic::shortest
