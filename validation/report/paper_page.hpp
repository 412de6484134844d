// The page that goes through the paper and says what holds.
#pragma once

#include <string>

#include "report/paper_record.hpp"

namespace vcrit::validation::report {

/// Needs nothing but itself; drawings need its own scripts, everything else shows without.
std::string paper_page(const PaperContents& contents);

}  // namespace vcrit::validation::report
