// What is shortest in names of abbreviations.
#pragma once

#include <ginac/ginac.h>

#include <cstddef>
#include <utility>
#include <vector>

#include "analysis/abbreviations.hpp"
#include "derivation/model.hpp"

namespace vcrit::symbolic {

/// The change with both names, with either, and as it is: what is shorter in none keeps its place
/// behind the others.
std::vector<Change> abbreviated(const Abbreviations& names, const Change& change);

/// Each + - * / ^ sqrt abs of an expression as it is printed.
int printed_operations(const GiNaC::ex& expression);

/// f of the change in the names in which its `length` is the least, the first of equal ones.
template <typename F, typename Length>
auto shortest_in(const Abbreviations& names, const Change& change, const F& f,
                 const Length& length) {
  std::vector<Change> changes = abbreviated(names, change);
  auto best = f(changes.front());
  int least = length(best);
  for (std::size_t i = 1; i < changes.size(); ++i) {
    auto other = f(changes[i]);
    if (const int operations = length(other); operations < least) {
      least = operations;
      best = std::move(other);
    }
  }
  return best;
}

}  // namespace vcrit::symbolic
