// "Try it": number fields and sliders for the scene's parameters, and the simulator that answers in
// the page (live/); explorer.js moves it.
#pragma once

#include <string>
#include <vector>

#include "problem/problem.hpp"
#include "record/fields.hpp"

namespace vcrit::validation::report {

/// For the page's template; null for a scene without an explorer. All values must be there.
record::Json explorer_record(const Problem& problem);

/// What must run on the page, in this order; empty for a scene without an explorer.
std::vector<std::string> explorer_scripts(const Problem& problem);

}  // namespace vcrit::validation::report
