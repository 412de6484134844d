// The page about extremes.
#pragma once

#include <string>

#include "report/extremes_record.hpp"

namespace vcrit::validation::report {

std::string extremes_page(const ExtremesContents& contents);

}  // namespace vcrit::validation::report
