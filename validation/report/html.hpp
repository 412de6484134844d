// Text made safe for the page. Everything that comes from a scene goes through here.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace vcrit::validation::report {

/// For text and for attribute values in quotes. Bytes that are not UTF-8 and control characters
/// become the replacement character.
std::string escape(std::string_view text);

/// JSON as the content of a <script type="application/json">: no character that could end it.
std::string json_for_page(const nlohmann::ordered_json& value);

/// One word of a command line, quoted if a shell would read it otherwise.
std::string shell_word(const std::string& word);

}  // namespace vcrit::validation::report
