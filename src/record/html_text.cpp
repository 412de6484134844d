#include "record/html_text.hpp"

#include <nlohmann/json.hpp>

#include "record/json_text.hpp"

namespace vcrit::record {

namespace {

/// The JSON library already knows how to replace what is not UTF-8.
std::string valid_utf8(std::string_view text) {
  const nlohmann::ordered_json json = std::string(text);
  return read_json(json_text(json)).get<std::string>();
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
