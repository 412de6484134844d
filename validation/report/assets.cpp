#include "report/assets.hpp"

#include <charconv>

#include "base/errors.hpp"

#define VCRIT_SCRIPT(symbol, name, version, hash) \
  extern "C" const char vcrit_##symbol[], vcrit_##symbol##_end[];
#include "asset_scripts.inc"
#undef VCRIT_SCRIPT
extern "C" const char vcrit_style[], vcrit_style_end[];

namespace vcrit::validation::report {

namespace {

std::string_view between(const char* begin, const char* end) {
  return {begin, static_cast<std::size_t>(end - begin)};
}

unsigned byte_at(std::string_view hex, std::size_t index) {
  if (2 * index >= hex.size()) return 0;
  unsigned value = 0;
  const char* begin = hex.data() + 2 * index;
  const auto read = std::from_chars(begin, begin + 2, value, 16);
  ensure(read.ptr == begin + 2, "two hexadecimal digits a byte");
  return value;
}

}  // namespace

std::string base64_of_hex(std::string_view hex) {
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::size_t bytes = hex.size() / 2;
  std::string text;
  for (std::size_t i = 0; i < bytes; i += 3) {
    const unsigned three = byte_at(hex, i) << 16 | byte_at(hex, i + 1) << 8 | byte_at(hex, i + 2);
    for (std::size_t j = 0; j < 4; ++j)
      text += i + j > bytes ? '=' : digits[three >> (18 - 6 * j) & 63];
  }
  return text;
}

const std::vector<Script>& scripts() {
  static const std::vector<Script> all{
#define VCRIT_SCRIPT(symbol, name, version, hash) \
  {name, version, between(vcrit_##symbol, vcrit_##symbol##_end), "sha256-" + base64_of_hex(hash)},
#include "asset_scripts.inc"
#undef VCRIT_SCRIPT
  };
  return all;
}

std::string_view style() { return between(vcrit_style, vcrit_style_end); }

}  // namespace vcrit::validation::report
