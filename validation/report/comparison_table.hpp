// What was compared with what, as a table.
#pragma once

#include <string>
#include <vector>

#include "scene_report.hpp"

namespace vcrit::validation::report {

/// `agreeing`: the style of what passed; but for "passed" it is said to agree and no more.
std::string comparison_table(const std::vector<Comparison>& comparisons,
                             const std::string& agreeing = "passed");

/// "12 comparisons passed, 2 not run"
std::string count_words(const std::vector<Comparison>& comparisons);

/// Which is nearest to its tolerance, or why one broke; empty where none was made. Not escaped.
std::string tightest_words(const std::vector<Comparison>& comparisons);

}  // namespace vcrit::validation::report
