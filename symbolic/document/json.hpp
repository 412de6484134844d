// The derivation of a scene as one JSON object.
#pragma once

#include <string>

#include "document/content.hpp"

namespace vcrit::symbolic {

std::string json_document(const Problem& problem, const Findings& findings);

}  // namespace vcrit::symbolic
