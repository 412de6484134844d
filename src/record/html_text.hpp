// Text made safe for a page in HTML.
#pragma once

#include <string>
#include <string_view>

namespace vcrit::record {

/// For text and for attribute values in quotes. Bytes that are not UTF-8 and control characters
/// become the replacement character.
std::string html_text(std::string_view text);

}  // namespace vcrit::record
