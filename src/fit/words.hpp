// What a fit says in words, for people.
#pragma once

#include <string>
#include <vector>

#include "fit/fit.hpp"

namespace vcrit::fit {

/// Its length, its misfit, what to mind, and how the table was read. Arguments are named by their
/// keys (base/arguments.hpp).
std::vector<std::string> in_words(const StiffnessTable& data, const Fit& fit);

}  // namespace vcrit::fit
