// What each comparison of a scene claims, by which means, and what both sides share: the words of
// the page of evidence.
#pragma once

#include <string>

#include "compare/scene_report.hpp"

namespace vcrit::validation::report {

struct ComparisonWords {
  const char* words;   ///< "v* from the formula = v* from simulation"
  const char* means;   ///< what it is compared by
  const char* shared;  ///< what both sides have in common, so that a fault there is not seen
};

/// Of a comparison by its key; one whose key is not known claims what its own names say.
ComparisonWords claim_of(const Comparison& comparison);

}  // namespace vcrit::validation::report
