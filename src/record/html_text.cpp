#include "record/html_text.hpp"

#include <nlohmann/json.hpp>

namespace vcrit::record {

namespace {

using nlohmann::ordered_json;

/// The JSON library already knows how to replace what is not UTF-8.
std::string valid_utf8(std::string_view text) {
  const std::string json =
      ordered_json(std::string(text)).dump(-1, ' ', false, ordered_json::error_handler_t::replace);
  return ordered_json::parse(json).get<std::string>();
}

}  // namespace

std::string html_text(std::string_view text) {
  std::string result;
  for (const char c : valid_utf8(text)) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      case '\n':
      case '\t':
        result += c;
        break;
      case '\r':
        break;
      default:
        if (static_cast<unsigned char>(c) < 0x20)
          result += "\xEF\xBF\xBD";
        else
          result += c;
    }
  }
  return result;
}

}  // namespace vcrit::record
