// The page's own scripts, and the policy that lets them run and nothing else.
#pragma once

#include <string>

namespace vcrit::validation::report {

/// The content security policy, for document_head().
std::string script_policy();

/// For the end of the page's body.
std::string script_elements();

}  // namespace vcrit::validation::report
