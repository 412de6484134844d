#include "scene/arithmetic.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

#include "base/identifiers.hpp"
#include "base/spelled_names.hpp"
#include "network/expression.hpp"
#include "scene/cursor.hpp"
#include "scene/quantities.hpp"

namespace vcrit {

namespace {

constexpr int largest_power = 9;

// Digits beyond these say nothing of a measured number.
constexpr std::size_t longest_number = 40;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

class ArithmeticParser : Cursor {
 public:
  using Cursor::Cursor;

  AmountTreePointer whole() {
    AmountTreePointer all = sum();
    if (!at_end()) refuse(found(), "\"+\", \"*\", \"/\", \"^\" or the end");
    return all;
  }

 private:
  AmountTreePointer sum() {
    AmountTreePointer all = product();
    while (accept('+')) all = made(AmountTree::Kind::sum, all, product());
    if (peek() == '-')
      refuse("a difference", "sums, products and quotients, which are positive as their parts are");
    return all;
  }

  AmountTreePointer product() {
    AmountTreePointer all = power();
    for (;;) {
      if (accept('*'))
        all = made(AmountTree::Kind::product, all, power());
      else if (accept('/'))
        all = made(AmountTree::Kind::quotient, all, power());
      else
        return all;
    }
  }

  AmountTreePointer power() {
    const AmountTreePointer base = operand();
    if (!accept('^')) return base;
    const bool below = accept('-');
    const int exponent = whole_number(largest_power, "a whole power from 1 to 9");
    AmountTreePointer all = base;
    for (int i = 1; i < exponent; ++i) all = made(AmountTree::Kind::product, all, base);
    if (!below) return all;
    return made(AmountTree::Kind::quotient, make_expression(TypedNumber{1, "1"}), all);
  }

  AmountTreePointer operand() {
    const char next = peek();
    if (is_digit(next)) return number();
    refuse_name_beyond_ascii(text_, position_, place_);
    if (is_letter(next)) return name();
    if (next != '(') refuse(found(), "a name, a number above 0 or \"(\"");
    return group();
  }

  AmountTreePointer group() {
    const Place opening = here();
    if (++depth_ > deepest_nesting)
      refuse("too many brackets in one another", fmt::format("at most {}", deepest_nesting));
    accept('(');
    AmountTreePointer inside = sum();
    if (!accept(')'))
      throw InputError(opening, fmt::format("\"(\" without \")\" in \"{}\"", text_), "\")\"");
    --depth_;
    return inside;
  }

  AmountTreePointer number() {
    const Place at = here();
    double value = 0;
    const char* const begin = text_.data() + position_;
    const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
    const std::string digits(begin, end);
    if (error != std::errc{} || !std::isnormal(value) || digits.size() > longest_number)
      throw InputError(at, fmt::format("number {}", digits), "a number above 0, of ordinary size");
    position_ += digits.size();
    count();
    return make_expression(TypedNumber{value, digits});
  }

  AmountTreePointer name() {
    const Place at = here();
    const auto word = [](char c) { return is_letter(c) || is_digit(c) || c == '_'; };
    const std::string_view rest = std::string_view(text_).substr(position_);
    const auto end = std::find_if_not(rest.begin(), rest.end(), word);
    std::string name(rest.begin(), end);
    if (const auto why = unsafe_as_identifier(name))
      throw InputError(at, fmt::format("name \"{}\", which {}", name, *why), "another name");
    position_ += name.size();
    if (!accept('[')) return make_expression(Symbol{std::move(name)}, NumberRole::factor);
    const int entry = whole_number(most_entries_named, "the number of an entry, from 1");
    if (!accept(']')) refuse(found(), "\"]\"");
    return make_expression(Symbol{std::move(name), entry}, NumberRole::factor);
  }

  int whole_number(int most, const char* expected) {
    const auto value = whole_number_up_to(most);
    if (!value) refuse(found(), expected);
    return *value;
  }

  AmountTreePointer made(AmountTree::Kind kind, AmountTreePointer first, AmountTreePointer second) {
    count();
    return make_expression(kind, std::move(first), std::move(second));
  }

  void count() {
    if (++operations_ > most_operations_of_one)
      throw InputError(place_, "an expression of very many operations",
                       fmt::format("at most {}", most_operations_of_one));
  }

  std::string found() {
    return at_end() ? "the end" : fmt::format("\"{}\"", text_.substr(position_, 1));
  }
  [[noreturn]] void refuse(const std::string& what, const std::string& expected) {
    throw InputError(here(), fmt::format("{} in \"{}\"", what, text_), expected);
  }

  std::size_t operations_ = 0;
  int depth_ = 0;
};

// What is not a quantity: "8 N/um" has a blank behind its number, or nothing.
bool goes_on_as_expression(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const std::size_t next =
      text.find_first_not_of(" \t", static_cast<std::size_t>(end - text.data()));
  return error != std::errc::invalid_argument && next != text.npos &&
         std::string_view("+*/^").find(text[next]) != std::string_view::npos;
}

}  // namespace

std::optional<std::string> expression_in(const toml::node& value) {
  if (!value.is_string() || bare_name(value)) return std::nullopt;
  const auto& text = value.ref<std::string>();
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == text.npos || text == "inf" || text == "nan") return std::nullopt;
  const bool begins = is_letter(text[first]) || text[first] == '(';
  if (begins || (is_digit(text[first]) && goes_on_as_expression(text.substr(first)))) return text;
  return std::nullopt;
}

AmountTreePointer parse_arithmetic(const std::string& text, const Place& place) {
  return ArithmeticParser(text, place).whole();
}

}  // namespace vcrit
