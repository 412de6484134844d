// What a formula of v* says in words: what does not enter, where v* vanishes or is infinite, up to
// which amplitude it holds. Each is decided from the derivation by exact means: evaluated modulo a
// prime where a symbol has two values (analysis/residues.hpp), or by the conditions of resonance.
#pragma once

#include <string>
#include <vector>

#include "derivation/derivation.hpp"
#include "formula/prose.hpp"
#include "problem/problem.hpp"
#include "shortest/shortest.hpp"

namespace vcrit::symbolic {

struct Fact {
  std::string key;                                   ///< for programs: "rheology_cancels"
  Prose words;                                       ///< a sentence, without the stop at its end
  std::vector<ShortestForm::Definition> lines = {};  ///< what it says as mathematics, or none
};

/// In the order in which people want to know them. Of more than 200 elements none: nobody reads the
/// formula.
std::vector<Fact> facts(const Derivation& derivation);
/// Derived for it, unless it is too large; in the scene's names.
std::vector<std::string> facts_in_text(const Problem& problem);

/// "words: a = b; c = d"
std::string text_of(const Fact& fact);

/// Names as people list them: "k1, k2 and c1", of an array with all of its entries its name.
Prose listed(const std::vector<Symbol>& symbols, const Problem& problem);

}  // namespace vcrit::symbolic
