// A family's results on their way from the process that found them.
#pragma once

#include <string>

#include "extremes/contents.hpp"

namespace vcrit::validation::extremes {

std::string handed_over(const FamilyResult& result);
FamilyResult taken_over(const std::string& text);

}  // namespace vcrit::validation::extremes
