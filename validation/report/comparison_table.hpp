// What was compared with what, as a table.
#pragma once

#include <string>
#include <vector>

#include "scene_report.hpp"

namespace vcrit::validation::report {

/// Where Eq. 24 does not apply, ways to evaluate it agree, which is no success.
std::string comparison_table(const std::vector<Comparison>& comparisons,
                             bool formula_applies = true);

/// "12 comparisons passed, 2 not run"
std::string count_words(const std::vector<Comparison>& comparisons);

/// Which is nearest to its tolerance, or why one broke; empty where none was made. Not escaped.
std::string tightest_words(const std::vector<Comparison>& comparisons);

}  // namespace vcrit::validation::report
