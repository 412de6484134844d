// What is found out about a scene's formula for a document.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/abbreviations.hpp"
#include "analysis/asymptotes.hpp"
#include "analysis/limits.hpp"
#include "analysis/resonance.hpp"
#include "analysis/sensitivities.hpp"
#include "derivation/derivation.hpp"
#include "document/print.hpp"
#include "facts/facts.hpp"
#include "formula/line.hpp"
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
  /// What people read, in g and Z where these make it shorter.
  struct Abbreviated {
    Abbreviations names;
    std::vector<Asymptote> asymptotes;
    std::vector<Resonance> resonances;
    Sensitivities sensitivities;  ///< of all formats but JSON, as they take seconds
  } abbreviated;
  std::vector<Line> extrema;
  Sensitivities sensitivities;                  ///< of JSON
  std::optional<std::vector<Line>> separation;  ///< of a contact that may open
  std::string beyond_simulation;                ///< why it has no motion in time
  std::vector<Line> half_space;                 ///< below an indenter
  std::optional<ShortestForm> shortest;   ///< in named steps: shortest, or in storage and loss
  std::string why_complex;                ///< why there is no shortest form
  std::optional<ShortestForm> in_groups;  ///< dimensionless; form_lines has the groups
  std::vector<Fact> facts;                ///< what the formula says
};

/// Throws ModelError where the form or what is asked besides is too large, or the scene has none.
Findings findings_of(const Problem& problem, const DocumentOptions& options);

/// The document of what was found, in any format but JSON, or in JSON if the findings are for that.
/// `system` is of Format::system, `standalone` of LaTeX and HTML, as in DocumentOptions.
std::string print_findings(const Problem& problem, const Findings& findings, Format format,
                           const std::string& system = {}, bool standalone = false);

}  // namespace vcrit::symbolic
