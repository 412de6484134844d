// What the derivation of a scene says, apart from its markup.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/asymptotes.hpp"
#include "analysis/limits.hpp"
#include "analysis/resonance.hpp"
#include "analysis/sensitivities.hpp"
#include "derivation/derivation.hpp"
#include "document/fitted.hpp"
#include "document/print.hpp"
#include "formula/line.hpp"
#include "formula/prose.hpp"
#include "problem/problem.hpp"
#include "shortest/shortest.hpp"

namespace vcrit::symbolic {

/// Everything asked for; what was not asked for is empty.
struct Findings {
  Derivation derivation;
  std::string fingerprint;
  ResultForm form = ResultForm::shortest;
  std::vector<Line> form_lines;  ///< of the form that was asked for
  std::vector<Limit> limits;
  std::vector<Asymptote> asymptotes;
  std::vector<Resonance> resonances;
  std::vector<Line> extrema;
  Sensitivities sensitivities;
  std::optional<std::vector<Line>> parting;  ///< of surfaces that may part
  std::string beyond_simulation;             ///< why it has no motion in time
  std::vector<Line> half_space;              ///< below an indenter
  std::optional<ShortestForm> shortest;      ///< where it was asked for and fits a page
};

/// An equation as it is to be written.
struct Equation {
  Form left;
  Signed right;
  FittedEquation::Range range = {};  ///< of an index in it
};

/// The definitions of a shortest form, then v*.
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

struct Section {
  Prose title;  ///< empty: the derivation itself
  Prose note;   ///< in front of the blocks
  std::vector<DocumentBlock> blocks;
  Prose remark;  ///< behind them
  std::vector<Prose> items = {};        ///< a list
  std::vector<SymbolRow> symbols = {};  ///< a table
};

/// The sections that have something to say.
std::vector<Section> sections(const Findings& findings);

/// v* ~ coefficient omega^power.
Line asymptote_line(const Asymptote& asymptote);

/// The scene's title, or what is derived.
std::string title_of(const Problem& problem);

}  // namespace vcrit::symbolic
