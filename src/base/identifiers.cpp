#include "base/identifiers.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <numeric>
#include <utility>

namespace vcrit {

namespace {

// Words enough for a name, short enough for messages, tables and generated code.
constexpr std::size_t longest_name = 64;

// Keywords of C++20 and of the other languages code may be generated for, and macros that common
// compilers define without being asked.
constexpr auto reserved = std::to_array<std::string_view>(
    {"alignas",      "alignof",   "and",          "and_eq",
     "asm",          "assert",    "async",        "auto",
     "await",        "bitand",    "bitor",        "bool",
     "break",        "case",      "catch",        "char",
     "char16_t",     "char32_t",  "char8_t",      "class",
     "co_await",     "co_return", "co_yield",     "compl",
     "concept",      "const",     "const_cast",   "consteval",
     "constexpr",    "constinit", "continue",     "decltype",
     "def",          "default",   "del",          "delete",
     "do",           "double",    "dynamic_cast", "elif",
     "else",         "enum",      "errno",        "except",
     "explicit",     "export",    "extern",       "false",
     "finally",      "float",     "for",          "friend",
     "from",         "function",  "global",       "goto",
     "if",           "import",    "in",           "inline",
     "int",          "is",        "lambda",       "let",
     "linux",        "long",      "mutable",      "namespace",
     "new",          "noexcept",  "nonlocal",     "not",
     "not_eq",       "nullptr",   "operator",     "or",
     "or_eq",        "pass",      "private",      "protected",
     "public",       "raise",     "register",     "reinterpret_cast",
     "requires",     "restrict",  "return",       "short",
     "signed",       "sizeof",    "static",       "static_assert",
     "static_cast",  "stderr",    "stdin",        "stdout",
     "struct",       "switch",    "template",     "this",
     "thread_local", "throw",     "true",         "try",
     "typedef",      "typeid",    "typename",     "typeof",
     "union",        "unix",      "unsigned",     "using",
     "var",          "virtual",   "void",         "volatile",
     "wchar_t",      "while",     "with",         "xor",
     "xor_eq",       "yield"});

bool letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool word(char c) { return letter(c) || std::isdigit(static_cast<unsigned char>(c)) || c == '_'; }

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({substituted, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

std::optional<std::string> unsafe_as_identifier(std::string_view name) {
  if (name.empty() || !letter(name.front()) || !std::all_of(name.begin(), name.end(), word))
    return "is not a letter followed by letters, digits and underscores";
  if (name.size() > longest_name) return "is longer than 64 characters";
  if (name.find("__") != name.npos) return "has two underscores in a row, which C++ reserves";
  if (std::binary_search(reserved.begin(), reserved.end(), name))
    return "is a reserved word of C++ or another target language";
  // Macros of the standard library and compilers are written in capitals (NULL, INFINITY, M_PI).
  const bool macro = name.size() > 2 && std::none_of(name.begin(), name.end(), [](char c) {
                       return std::islower(static_cast<unsigned char>(c)) != 0;
                     });
  if (macro) return "is written in capitals like a macro";
  return std::nullopt;
}

namespace {

/// "frequency" of "freq", where no other candidate begins so.
std::optional<std::string> the_one_that_begins(std::string_view name,
                                               const std::vector<std::string>& candidates) {
  constexpr std::size_t shortest_beginning = 3;
  const auto begins = [&](const std::string& each) { return each.starts_with(name); };
  if (name.size() < shortest_beginning ||
      std::count_if(candidates.begin(), candidates.end(), begins) != 1)
    return std::nullopt;
  return *std::find_if(candidates.begin(), candidates.end(), begins);
}

bool is_same_but_for_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char x, unsigned char y) {
    return std::tolower(x) == std::tolower(y);
  });
}

}  // namespace

std::optional<std::string> nearest(std::string_view name,
                                   const std::vector<std::string>& candidates) {
  std::optional<std::string> best;
  if (name.size() > longest_name) return best;
  for (const std::string& candidate : candidates)
    if (is_same_but_for_case(name, candidate)) return candidate;
  if (const auto whole = the_one_that_begins(name, candidates)) return whole;
  std::size_t distance = std::max<std::size_t>(2, name.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    if (candidate.size() >= name.size() + distance) continue;
    const std::size_t d = edit_distance(name, candidate);
    if (d < distance && d < std::max(name.size(), candidate.size())) best = candidate, distance = d;
  }
  return best;
}

}  // namespace vcrit
