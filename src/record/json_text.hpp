// Records as text of JSON, and back: the one place where the reader and writer are compiled.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace vcrit::record {

/// Each member of an object on a line, so far in; with -1 all on one. Bytes that are not UTF-8, as
/// in names of files, become the replacement character.
std::string json_text(const nlohmann::ordered_json& value, int indent = -1);

/// On one line, letters beyond ASCII escaped.
std::string json_text_in_ascii(const nlohmann::ordered_json& value);

/// Of text that the program wrote itself.
nlohmann::ordered_json read_json(const std::string& text);

}  // namespace vcrit::record
