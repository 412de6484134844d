#include "scene/syntax.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <initializer_list>
#include <string_view>

#include "base/numbers.hpp"
#include "base/spelled_names.hpp"
#include "base/trimmed.hpp"
#include "base/unit_advice.hpp"

namespace vcrit::document {

namespace {

constexpr std::string_view blanks = " \t\r";

struct LineEnds {
  std::size_t begin = 0, end = 0;
};

LineEnds ends_of(const std::string& text, int line) {
  std::size_t begin = 0;
  for (int i = 1; i < line; ++i) {
    const std::size_t next = text.find('\n', begin);
    if (next == text.npos) return {text.size(), text.size()};
    begin = next + 1;
  }
  return {begin, std::min(text.find('\n', begin), text.size())};
}

bool is_key_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
}

struct KeyAndValue {
  std::string_view key, value;
};

// Of a line that begins with a bare key.
std::optional<KeyAndValue> key_and_value(std::string_view line) {
  const std::size_t equals = line.find('=');
  if (equals == line.npos) return std::nullopt;
  const std::string_view key = trimmed(line.substr(0, equals), blanks);
  if (key.empty()) return std::nullopt;
  for (const char c : key)
    if (!is_key_character(c)) return std::nullopt;
  return KeyAndValue{key, trimmed(line.substr(equals + 1), blanks)};
}

bool is_word(std::string_view text) {
  if (text.empty()) return false;
  const auto first = static_cast<unsigned char>(text.front());
  return std::isalpha(first) != 0 || first >= 0x80;  // "um", and the micro sign
}

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

// Nothing for values that lack no quotes.
std::string advice_on_bare(const KeyAndValue& line, std::string_view value) {
  for (const char* fine : {"true", "false", "inf", "nan"})
    if (value == fine) return "";
  if (is_one_of(value, {"True", "TRUE", "yes", "Yes", "on"}))
    return fmt::format("write {} = true", line.key);
  if (is_one_of(value, {"False", "FALSE", "no", "No", "off"}))
    return fmt::format("write {} = false", line.key);
  const LeadingNumber number = leading_number(value);
  if (number.length == 0 && (is_word(value) || value.starts_with('(')))
    return fmt::format("a text needs quotes: {} = \"{}\"", line.key, value);
  const std::string_view behind = trimmed(value.substr(number.length), blanks);
  if (number.length > 0 && is_word(behind))
    return fmt::format("a value with a unit needs quotes: \"{}\"", value);
  return number.length > 0 ? advice_on_comma(value.substr(0, number.length), behind) : "";
}

// A text in plain quotes, of one line, that goes on to its end.
bool lacks_end(std::string_view value) {
  return value.starts_with('"') && !value.starts_with("\"\"\"") && value.find('"', 1) == value.npos;
}

// The name in toml++'s "cannot redefine existing string 'frequency'"; empty of other errors.
std::string defined_twice(std::string_view description) {
  const std::size_t begin = description.find("cannot redefine existing");
  const std::size_t open = begin == description.npos ? begin : description.find('\'', begin);
  const std::size_t close = open == description.npos ? open : description.find('\'', open + 1);
  if (close == description.npos) return {};
  return std::string(description.substr(open + 1, close - open - 1));
}

}  // namespace

InputError syntax_error(const std::string& text, const Place& place,
                        const std::string& description) {
  const LineEnds ends = ends_of(text, place.line);
  const std::string_view line = std::string_view(text).substr(ends.begin, ends.end - ends.begin);
  const auto found = key_and_value(line);
  const std::string_view value =
      found ? trimmed(found->value.substr(0, found->value.find('#')), blanks) : std::string_view();
  if (const std::string advice = found ? advice_on_bare(*found, value) : ""; !advice.empty())
    return {place, fmt::format("{} = {}", found->key, value), "a number, or a text in quotes",
            advice};
  if (found && lacks_end(found->value))
    return {place, fmt::format("{} = {} without its closing quote", found->key, found->value),
            "a text in quotes", fmt::format("write {} = {}\"", found->key, value)};
  if (const std::string twice = defined_twice(description); !twice.empty())
    return {place, fmt::format("\"{}\" for the second time", twice), "each name once",
            "leave one of them out"};
  if (description.find("utf-8") != description.npos)
    return {place, "a letter that is not UTF-8", "a scene in TOML", "save the file as UTF-8"};
  if (place.file.ends_with(".csv"))
    return {place, "a table", "a scene in TOML", "vcrit fit makes a scene of measured stiffness"};
  for (std::size_t i = 0; i < std::min(line.find_first_of("=#"), line.size()); ++i)
    if (const auto name = complaint_beyond_ascii(line, i, {place.file, place.line, 1}))
      return *name;
  return {place, fmt::format("no TOML ({})", description), "a scene in TOML"};
}

std::optional<std::string> without_line(const std::string& text, int line, bool again) {
  const LineEnds ends = ends_of(text, line);
  const auto found =
      key_and_value(std::string_view(text).substr(ends.begin, ends.end - ends.begin));
  if (!found) return std::nullopt;
  const std::string in_place = again ? "" : fmt::format("{} = \"unreadable_{}\"", found->key, line);
  return text.substr(0, ends.begin) + in_place + text.substr(ends.end);
}

}  // namespace vcrit::document
