// What a report shows of a scene whose v* is no formula: below an indenter on a drive that gives.
#pragma once

#include "compare/scene_report.hpp"
#include "compare/witnesses.hpp"

namespace vcrit::validation {

/// Its v* and its friction from rest to sliding, both held against plain cells that march in the
/// witnesses' half-space, and why nothing is compared with a formula: `why`, which is the report's
/// `failure`, too. Throws InputError for missing values.
SceneReport report_without_formula(const Problem& problem, const std::string& why,
                                   const Witnesses& witnesses = own_witnesses());

}  // namespace vcrit::validation
