// What every page begins with.
#pragma once

#include <string>

namespace vcrit::validation::report {

/// From the doctype to </head>, with the style; `policy` is the page's content security policy.
std::string document_head(const std::string& title, const std::string& policy);

}  // namespace vcrit::validation::report
