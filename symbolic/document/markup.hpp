// A document in one markup, by templates/NAME.mustache.
#pragma once

#include <string>
#include <vector>

#include "document/content.hpp"

namespace vcrit::symbolic {

/// Any format but JSON; LaTeX as a file of its own where it is to be `standalone`.
std::string markup_document(Format format, const std::string& title,
                            const std::vector<DocumentSection>& sections, bool standalone);

}  // namespace vcrit::symbolic
