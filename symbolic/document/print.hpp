// The derivation of a scene as a document.
#pragma once

#include <string>
#include <vector>

#include "problem/problem.hpp"

namespace vcrit::symbolic {

/// system: the result alone, as another system reads it.
enum class Format { text, latex, markdown, html, json, system };

/// How the result is written: as the shortest real formula in named steps (where that fits a page,
/// else in complex stiffnesses); in complex stiffnesses, however small; in storage and loss of each
/// network; besides the shortest as a rational function of omega^2, or in dimensionless groups; or
/// multiplied out.
enum class ResultForm { shortest, nested, storage_loss, rational, dimensionless, expanded };

struct DocumentOptions {
  Format format = Format::text;
  bool limits = false;  ///< with asymptotes and resonances
  bool sensitivities = false;
  ResultForm form = ResultForm::shortest;
  bool standalone = false;  ///< LaTeX: an article that compiles as it is, no part of one
  double budget = 5000;     ///< terms of polynomials up to which v* is expanded, or rational
  std::string system = {};  ///< of Format::system, by its name
};

/// Systems that take the formula: "sympy", ..., in the order of --format.
const std::vector<std::string>& system_names();

/// Throws InputError for a system with limits or sensitivities, and for what cannot be standalone.
void check_options(const DocumentOptions& options);

/// What `vcrit derive` prints; the same bytes in every run. Throws ModelError where the rational
/// or the expanded form is beyond the budget and where storage and loss cannot be written out, and
/// InputError as check_options() does.
std::string print(const Problem& problem, const DocumentOptions& options);

}  // namespace vcrit::symbolic
