#include "record/json_text.hpp"

#include <nlohmann/json.hpp>

namespace vcrit::record {

using nlohmann::ordered_json;

std::string json_text(const ordered_json& value, int indent) {
  return value.dump(indent, ' ', false, ordered_json::error_handler_t::replace);
}

std::string json_text_in_ascii(const ordered_json& value) {
  return value.dump(-1, ' ', true, ordered_json::error_handler_t::replace);
}

ordered_json read_json(const std::string& text) { return ordered_json::parse(text); }

}  // namespace vcrit::record
