// A document in one markup.
#pragma once

#include <string>
#include <vector>

#include "document/content.hpp"

namespace vcrit::symbolic {

std::string text_document(const std::string& title, const std::vector<Section>& sections);
std::string latex_document(const std::string& title, const std::vector<Section>& sections);
std::string markdown_document(const std::string& title, const std::vector<Section>& sections);

}  // namespace vcrit::symbolic
