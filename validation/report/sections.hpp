// Sections of pages that go through many comparisons.
#pragma once

#include <string>
#include <vector>

#include "scene_report.hpp"

namespace vcrit::validation::report {

/// Green or red, with how many passed and which is nearest to its tolerance.
std::string verdict(const std::vector<Comparison>& comparisons);

/// `title` and `content` are HTML; the comparisons follow, unfolded where one failed.
std::string section(const std::string& id, const std::string& title, const std::string& content,
                    const std::vector<Comparison>& comparisons);

}  // namespace vcrit::validation::report
