// What the extremes came to, in a few sentences; their numbers come from the tallies.
#pragma once

#include <string>
#include <vector>

#include "extremes/contents.hpp"

namespace vcrit::validation::extremes {

/// One way over regions or families put together; without `digits` and `worst`.
Tally total(const Extremes& extremes, const std::string& way, const std::string& key = {});

Simulated simulated_total(const Extremes& extremes);

/// What is certified where, and where it stops being so.
std::vector<std::string> in_words(const Extremes& extremes);

}  // namespace vcrit::validation::extremes
