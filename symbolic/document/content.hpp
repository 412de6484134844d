// What the derivation of a scene says, apart from its markup.
#pragma once

#include <string>
#include <vector>

#include "analysis/asymptotes.hpp"
#include "document/findings.hpp"
#include "document/fitted.hpp"
#include "formula/form.hpp"
#include "formula/line.hpp"
#include "formula/prose.hpp"
#include "problem/problem.hpp"
#include "shortest/shortest.hpp"

namespace vcrit::symbolic {

/// An equation as it is to be written.
struct Equation {
  Form left;
  Signed right;
  FittedEquation::IndexRange range = {};  ///< of an index in it
};

/// The definitions of a form, then v*.
std::vector<Equation> equations_of(const ShortestForm& form);

/// Some lines under their words.
struct DocumentBlock {
  Prose words;
  std::vector<Line> lines;
  bool asymptotic = false;               ///< the last line is left ~ right
  std::vector<Equation> equations = {};  ///< behind the lines
};

/// A row of a table of symbols.
struct SymbolRow {
  Prose symbol, meaning;
  std::string unit;
};

struct DocumentSection {
  Prose title;  ///< empty: the derivation itself
  Prose note;   ///< in front of the blocks
  std::vector<DocumentBlock> blocks;
  std::vector<Prose> items = {};        ///< a list
  std::vector<SymbolRow> symbols = {};  ///< a table
};

/// Where what the formula says stands: on a terminal first, so that the result is the last thing
/// seen; in a paper behind the result.
enum class FactsPlace { first, behind_the_result };

/// The sections that have something to say.
std::vector<DocumentSection> sections(const Findings& findings, FactsPlace place);

/// v* ~ coefficient omega^power.
Line asymptote_line(const Asymptote& asymptote);

/// The scene's title, or what is derived.
std::string title_of(const Problem& problem);

}  // namespace vcrit::symbolic
