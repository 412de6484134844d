// What the symbols of a formula stand for, in the words of exported formulas and generated code.
#pragma once

#include <map>
#include <string>

#include "base/units.hpp"
#include "problem/problem.hpp"

namespace vcrit::symbolic {

struct Meaning {
  std::string words;                      ///< "spring", "friction coefficient"
  Dimension dimension = Dimension::none;  ///< of its SI unit
};

/// Of every symbol that the problem has; an entry of an array has its own.
std::map<Symbol, Meaning> meanings_of(const Problem& problem);

}  // namespace vcrit::symbolic
