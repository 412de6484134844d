#include "base/messages.hpp"

#include <fmt/core.h>

#include "base/plain_text.hpp"

namespace vcrit {

namespace {

bool continues(std::string_view text, std::size_t i) {
  return i < text.size() && (byte_at(text, i) & 0xC0U) == 0x80U;
}

// Bytes of the character at `i`, 0 if there is none that prints: the table of well-formed UTF-8 in
// the Unicode standard (3-7), without those that steer.
std::size_t character(std::string_view text, std::size_t i) {
  const unsigned lead = byte_at(text, i);
  if (steering(text.substr(i)) > 0) return 0;
  if (lead < 0x80) return 1;
  if (lead < 0xC2 || lead > 0xF4 || !continues(text, i + 1)) return 0;
  const unsigned second = byte_at(text, i + 1);
  if (lead < 0xE0) return 2;
  if ((lead == 0xE0 && second < 0xA0) || (lead == 0xED && second > 0x9F) || !continues(text, i + 2))
    return 0;
  if (lead < 0xF0) return 3;
  if ((lead == 0xF0 && second < 0x90) || (lead == 0xF4 && second > 0x8F) || !continues(text, i + 3))
    return 0;
  return 4;
}

std::string escaped(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    if (const std::size_t length = character(text, i)) {
      result += text.substr(i, length);
      i += length;
    } else {
      result += text[i] == '\n' ? "\\n" : fmt::format("\\x{:02x}", byte_at(text, i));
      ++i;
    }
  }
  return result;
}

}  // namespace

std::string printable(std::string_view text) {
  if (text.size() <= longest_in_message) return escaped(text);
  const auto cut = [&](std::size_t at) {
    for (const std::size_t last = at + 3; at < last && continues(text, at);) ++at;
    return at;
  };
  const std::size_t head = cut(longest_in_message / 2);
  const std::size_t tail = cut(text.size() - longest_in_message / 2);
  return fmt::format("{} ... ({} more bytes) ... {}", escaped(text.substr(0, head)), tail - head,
                     escaped(text.substr(tail)));
}

}  // namespace vcrit
