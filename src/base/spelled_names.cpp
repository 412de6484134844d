#include "base/spelled_names.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <map>
#include <string>

#include "base/plain_text.hpp"

namespace vcrit {

namespace {

bool is_inside_character(std::string_view text, std::size_t i) {
  return (byte_at(text, i) & 0xC0U) == 0x80U;
}

/// The bytes of the character at `at`.
std::size_t size_of_character(std::string_view text, std::size_t at) {
  std::size_t size = 1;
  while (at + size < text.size() && is_inside_character(text, at + size)) ++size;
  return size;
}

std::uint32_t code_point(std::string_view character) {
  const auto first = byte_at(character, 0);
  if (character.size() == 1) return first;
  std::uint32_t code = first & (0x7FU >> character.size());
  for (std::size_t i = 1; i < character.size(); ++i)
    code = code << 6U | (byte_at(character, i) & 0x3FU);
  return code;
}

struct CodeRange {
  std::uint32_t first, last;
};

/// Scripts that people write names in, and raised and lowered digits; no dashes, signs or quotes.
constexpr std::array letters_beyond_ascii{
    CodeRange{0xAA, 0xAA},     CodeRange{0xB2, 0xB3},     CodeRange{0xB5, 0xB5},
    CodeRange{0xB9, 0xBA},     CodeRange{0xC0, 0xD6},     CodeRange{0xD8, 0xF6},
    CodeRange{0xF8, 0x2AF},    CodeRange{0x370, 0x58F},   CodeRange{0x5D0, 0x5EA},
    CodeRange{0x620, 0x64A},   CodeRange{0x900, 0x1FFF},  CodeRange{0x2070, 0x209C},
    CodeRange{0x2102, 0x214F}, CodeRange{0x3041, 0xD7A3}, CodeRange{0x1D400, 0x1D7FF}};

bool is_of_spelled_name(std::string_view character) {
  const std::uint32_t code = code_point(character);
  if (code < 0x80) return code == '_' || std::isalnum(static_cast<int>(code)) != 0;
  return std::any_of(letters_beyond_ascii.begin(), letters_beyond_ascii.end(),
                     [code](CodeRange each) { return each.first <= code && code <= each.last; });
}

/// In ASCII, where every letter has a usual spelling there; else empty.
std::string ascii_spelling(std::string_view name) {
  static const std::map<std::string_view, const char*> usual{
      {"α", "alpha"}, {"β", "beta"},  {"γ", "gamma"}, {"δ", "delta"},      {"ε", "eps"},
      {"ζ", "zeta"},  {"η", "eta"},   {"θ", "theta"}, {"κ", "kappa"},      {"λ", "lam"},
      {"μ", "mu"},    {"µ", "mu"},    {"ν", "nu"},    {"ξ", "xi"},         {"π", "pi"},
      {"ρ", "rho"},   {"σ", "sigma"}, {"τ", "tau"},   {"φ", "phi"},        {"χ", "chi"},
      {"ψ", "psi"},   {"ω", "omega"}, {"Ω", "Omega"}, {"\u2126", "Omega"}, {"ä", "ae"},
      {"ö", "oe"},    {"ü", "ue"},    {"ß", "ss"},    {"₀", "0"},          {"₁", "1"},
      {"₂", "2"},     {"₃", "3"},     {"₄", "4"}};
  std::string result;
  for (std::size_t at = 0; at < name.size();) {
    const std::string_view character = name.substr(at, size_of_character(name, at));
    const auto found = usual.find(character);
    if (character.size() > 1 && found == usual.end()) return {};
    result += character.size() == 1 ? std::string(character) : found->second;
    at += character.size();
  }
  return result;
}

}  // namespace

std::string_view name_beyond_ascii(std::string_view text, std::size_t at) {
  std::size_t begin = at, end = at;
  bool beyond = false;
  while (end < text.size()) {
    const std::string_view character = text.substr(end, size_of_character(text, end));
    if (!is_of_spelled_name(character)) break;
    beyond = beyond || character.size() > 1;
    end += character.size();
  }
  while (begin > 0) {
    std::size_t before = begin - 1;
    while (before > 0 && is_inside_character(text, before)) --before;
    const std::string_view character = text.substr(before, begin - before);
    if (!is_of_spelled_name(character)) break;
    beyond = beyond || character.size() > 1;
    begin = before;
  }
  return beyond ? text.substr(begin, end - begin) : std::string_view();
}

std::optional<InputError> complaint_beyond_ascii(std::string_view text, std::size_t at,
                                                 const Place& place) {
  const std::string_view name = name_beyond_ascii(text, at);
  if (name.empty()) return std::nullopt;
  Place there = place;
  there.column += static_cast<int>(name.data() - text.data());
  const std::string other = ascii_spelling(name);
  return InputError(there, fmt::format("name \"{}\", with letters beyond ASCII", name),
                    "a name of the letters a to z and A to Z, digits and underscores",
                    other.empty() ? "" : fmt::format("write {}", other));
}

void refuse_name_beyond_ascii(std::string_view text, std::size_t at, const Place& place) {
  if (const auto complaint = complaint_beyond_ascii(text, at, place)) throw InputError(*complaint);
}

}  // namespace vcrit
