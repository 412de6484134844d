#include "base/plain_text.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace vcrit {

namespace {

bool within(unsigned code, unsigned first, unsigned last) { return first <= code && code <= last; }

/// The character at the beginning, of up to three bytes in UTF-8: none that steers is longer.
unsigned code_of(std::string_view text, std::size_t size) {
  if (size == 1) return byte_at(text, 0);
  if (size == 2) return (byte_at(text, 0) & 0x1FU) << 6U | (byte_at(text, 1) & 0x3FU);
  return (byte_at(text, 0) & 0x0FU) << 12U | (byte_at(text, 1) & 0x3FU) << 6U |
         (byte_at(text, 2) & 0x3FU);
}

}  // namespace

unsigned byte_at(std::string_view text, std::size_t i) {
  return i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
}

std::size_t steering(std::string_view text) {
  const unsigned first = byte_at(text, 0);
  if (!text.empty() && (first < 0x20 || first == 0x7F)) return 1;
  // U+0080 to U+009F, U+061C.
  if (first == 0xC2 && within(byte_at(text, 1), 0x80, 0x9F)) return 2;
  if (first == 0xD8 && byte_at(text, 1) == 0x9C) return 2;
  if (first != 0xE2) return 0;
  // U+200E, U+200F, U+2028 to U+202E, U+2066 to U+2069.
  const unsigned code = code_of(text, 3);
  const bool steers =
      within(code, 0x200E, 0x200F) || within(code, 0x2028, 0x202E) || within(code, 0x2066, 0x2069);
  return steers && text.size() >= 3 ? 3 : 0;
}

std::string without_steering(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t size = steering(text);
    const bool shown = size == 0 || text.front() == '\n' || text.front() == '\t';
    out += shown ? std::string(1, text.front()) : fmt::format("\\u{{{:x}}}", code_of(text, size));
    text.remove_prefix(shown ? 1 : size);
  }
  return out;
}

std::string one_line(std::string_view text) {
  std::string out(text);
  std::replace_if(
      out.begin(), out.end(), [](char c) { return c == '\n' || c == '\t'; }, ' ');
  return without_steering(out);
}

}  // namespace vcrit
