// The page about the named rheologies: each with its drawing, stiffness, spectrum, v* and limits.
#pragma once

#include <string>

namespace vcrit::validation::report {

/// HTML in one file, the same bytes in every run. Nothing in it runs or is loaded.
std::string catalogue_page();

}  // namespace vcrit::validation::report
