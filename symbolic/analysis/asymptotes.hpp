// What v* tends to at low and at high frequency.
#pragma once

#include <ginac/ginac.h>

#include <string>
#include <vector>

#include "analysis/abbreviations.hpp"
#include "derivation/derivation.hpp"
#include "formula/line.hpp"
#include "formula/prose.hpp"

namespace vcrit::symbolic {

/// v* ~ coefficient omega^power.
struct Asymptote {
  bool high = false;  ///< infinity, and not 0
  std::string name;   ///< "omega -> 0" or "omega -> infinity"
  Prose title;        ///< the same
  int power = 0;
  Expression coefficient;         ///< positive, in the scene's symbols (and in definitions)
  std::vector<Line> definitions;  ///< where it is too large to be multiplied out: L_1, ..., L_n,
                                  ///< what K_1, ..., K_n tend to without their power of s
};

/// At omega to 0 and to infinity, for every scene; in g where this makes them shorter.
std::vector<Asymptote> asymptotes(const Derivation& derivation, const Abbreviations& names = {});

}  // namespace vcrit::symbolic
