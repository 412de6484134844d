// The page: everything in one file, readable without a network, on a phone and on paper.
#pragma once

#include <string>

#include "report/report_json.hpp"

namespace vcrit::validation::report {

/// Its content security policy lets only the page's own scripts run, by their hashes.
std::string page(const Contents& contents);

}  // namespace vcrit::validation::report
