// Long work that says how far it is.
#pragma once

#include <functional>
#include <string>

namespace vcrit::validation {

/// Told what is being done now, in a few words.
using Progress = std::function<void(const std::string& step)>;

}  // namespace vcrit::validation
