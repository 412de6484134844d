// Text made safe for XML and HTML. Everything that comes from a scene goes through here.
#pragma once

#include <string>
#include <string_view>

namespace vcrit::validation::figures {

/// For text and for attribute values in quotes. Bytes that are not UTF-8 and control characters
/// become the replacement character.
std::string escaped(std::string_view text);

}  // namespace vcrit::validation::figures
