#include "emit/words.hpp"

#include <string_view>

namespace vcrit::symbolic {

namespace {

// U+200E, U+200F, U+202A to U+202E and U+2066 to U+2069 in UTF-8.
bool turns_direction(std::string_view text) {
  if (text.size() < 3 || text[0] != '\xE2') return false;
  const auto second = static_cast<unsigned char>(text[1]);
  const auto third = static_cast<unsigned char>(text[2]);
  return (second == 0x80 && (third == 0x8E || third == 0x8F || (third >= 0xAA && third <= 0xAE))) ||
         (second == 0x81 && third >= 0xA6 && third <= 0xA9);
}

std::string harmless(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (turns_direction(std::string_view(text).substr(i))) {
      i += 2;
      continue;
    }
    const auto c = static_cast<unsigned char>(text[i]);
    out += c < 0x20 || c == 0x7F || c == '\\' ? ' ' : text[i];
  }
  return out;
}

}  // namespace

std::string comment(const std::string& text) {
  constexpr std::size_t width = 116;
  std::string rest = harmless(text), out;
  std::string indent;
  while (rest.size() > width) {
    std::size_t end = rest.rfind(' ', width);
    if (end == std::string::npos || end < 8) end = rest.find(' ', width);
    if (end == std::string::npos) break;
    out += "// " + indent + rest.substr(0, end) + "\n";
    rest.erase(0, end + 1);
    if (text.starts_with("  ")) indent = "      ";
  }
  return out + "// " + indent + rest + "\n";
}

}  // namespace vcrit::symbolic
