#include "scene/rational_stiffness.hpp"

#include <fmt/core.h>

#include <charconv>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "base/identifiers.hpp"
#include "base/spelled_names.hpp"
#include "network/expression.hpp"
#include "network/named_foster.hpp"
#include "scene/cursor.hpp"

namespace vcrit {

namespace {

constexpr std::size_t longest_quote = 60;
constexpr int most_operations_of_stiffness = 2000;
constexpr std::size_t longest_decimal = 24;  // characters: all that doubles have, and some

bool digit_or_point(char c) { return (c >= '0' && c <= '9') || c == '.'; }

template <class Algebra>
class StiffnessParser : Cursor {
 public:
  using Value = typename Algebra::Value;

  /// All by reference.
  StiffnessParser(const std::string& text, const Place& place, Algebra& algebra)
      : Cursor(text, place), algebra_(algebra) {}

  Value whole() {
    Value all = sum();
    if (!at_end()) refuse(found(), "\"+\", \"-\", \"*\", \"/\", \"^\" or the end");
    return all;
  }

 private:
  Value sum() {
    Value all = accept('-') ? algebra_.negative(product()) : product();
    for (;;) {
      if (accept('+'))
        all = plus(all, product());
      else if (accept('-'))
        all = plus(all, algebra_.negative(product()));
      else
        return all;
    }
  }

  Value product() {
    Value all = power();
    for (;;) {
      if (accept('*')) {
        all = times(all, power());
      } else if (accept('/')) {
        const Place at = here();
        const Value next = power();
        if (algebra_.is_zero(next))
          throw InputError(at, "a division by 0" + in_text(), "what is not 0");
        count();
        all = algebra_.over(all, next);
      } else {
        return all;
      }
    }
  }

  Value power() {
    const Value base = operand();
    if (!accept('^')) return base;
    const int exponent = whole_exponent();
    Value all = base;
    for (int i = 1; i < exponent; ++i) all = times(all, base);
    return all;
  }

  Value operand() {
    const char next = peek();
    if (digit_or_point(next)) return number();
    if (next == '(') return group();
    refuse_name_beyond_ascii(text_, position_, place_);
    if (!is_letter(next)) refuse(found(), "s, a number, the name of an element or \"(\"");
    if (next != 's' || is_part_of_name(position_ + 1)) return name();
    ++position_;
    return algebra_.s();
  }

  Value group() {
    const Place opening = here();
    if (++depth_ > deepest_nesting)
      refuse("too many brackets in one another", fmt::format("at most {}", deepest_nesting));
    accept('(');
    Value inside = sum();
    if (!accept(')')) throw InputError(opening, "\"(\" without \")\"" + in_text(), "\")\"");
    --depth_;
    return inside;
  }

  Value name() {
    const Place at = here();
    std::size_t end = position_;
    while (is_part_of_name(end)) ++end;
    Symbol symbol{text_.substr(position_, end - position_)};
    if (const auto why = unsafe_as_identifier(symbol.name))
      throw InputError(at, fmt::format("name \"{}\", which {}", symbol.name, *why), "another name");
    position_ = end;
    if (accept('[')) {
      const auto entry = whole_number_up_to(most_entries_named);
      if (!entry) refuse(found(), "the number of an entry, from 1");
      symbol.entry = *entry;
      if (!accept(']')) refuse(found(), "\"]\"");
    }
    count();
    return algebra_.named(symbol, at);
  }

  Value number() {
    const Place at = here();
    double value = 0;
    const char* const begin = text_.data() + position_;
    const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
    const std::string digits(begin, error == std::errc::invalid_argument ? begin + 1 : end);
    if (error != std::errc{} || digits.size() > longest_decimal)
      throw InputError(
          at, fmt::format("number {}", digits),
          fmt::format("a number of ordinary size, of at most {} characters", longest_decimal));
    position_ += digits.size();
    count();
    return algebra_.number(digits);
  }

  int whole_exponent() {
    const auto exponent = whole_number_up_to(largest_degree_of_stiffness);
    if (!exponent)
      refuse(found(), fmt::format("a whole power from 1 to {}", largest_degree_of_stiffness));
    return *exponent;
  }

  Value plus(const Value& a, const Value& b) {
    count();
    return algebra_.plus(a, b);
  }
  Value times(const Value& a, const Value& b) {
    count();
    return algebra_.times(a, b);
  }

  void count() {
    if (++operations_ > most_operations_of_stiffness)
      throw InputError(place_, "a stiffness of very many operations",
                       fmt::format("at most {}", most_operations_of_stiffness));
  }

  // Where that says more than the column.
  std::string in_text() const {
    return text_.size() > longest_quote ? "" : fmt::format(" in \"{}\"", text_);
  }
  bool is_part_of_name(std::size_t i) const {
    if (i >= text_.size()) return false;
    const char c = text_[i];
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  }
  std::string found() {
    if (at_end()) return "the end";
    std::size_t end = position_ + 1;
    while (is_part_of_name(end)) ++end;
    return fmt::format("\"{}\"", text_.substr(position_, end - position_));
  }
  [[noreturn]] void refuse(const std::string& what, const std::string& expected) {
    throw InputError(here(), what + in_text(), expected,
                     "stiffness = \"(12e6*s + 8e9)/(s + 1e3)\", of numbers and s, in SI units");
  }

  Algebra& algebra_;
  int operations_ = 0, depth_ = 0;
};

RationalFunction of_small_degree(const RationalFunction& stiffness, const Place& place) {
  RationalFunction all = stiffness.reduced();
  if (all.above.degree() > largest_degree_of_stiffness ||
      all.below.degree() > largest_degree_of_stiffness)
    refuse_large_stiffness(place);
  return all;
}

// Elements of its own that it names would be made of themselves.
void refuse_own_names(const FosterForm& form, const std::vector<Symbol>& leaves,
                      const std::string& name, const Place& place) {
  for (const Symbol& element : symbols_of(form.network))
    for (const Symbol& leaf : leaves)
      if (leaf.name == element.name)
        throw InputError(
            place,
            fmt::format("\"{}\", an element of network \"{}\" that its stiffness gives", leaf.name,
                        name),
            "another name of the element or of the network");
}

}  // namespace

TypedStiffness read_stiffness(const std::string& text, const std::string& name, const Place& place,
                              const StiffnessNames& names) {
  NameCollector collector(names);
  StiffnessParser(text, place, collector).whole();
  std::variant<FosterForm, NoFosterForm> form;
  if (collector.keys().empty()) {
    TypedNumberAlgebra algebra(place);
    form = foster_form(of_small_degree(StiffnessParser(text, place, algebra).whole(), place), name);
  } else {
    NamedAlgebra algebra(names, collector.leaves(), place);
    form = named_foster_form(StiffnessParser(text, place, algebra).whole(),
                             NamedAlgebra::variable(), name);
  }
  if (const auto* none = std::get_if<NoFosterForm>(&form))
    throw InputError(place, fmt::format("network \"{}\" with {}", name, none->found),
                     none->expected, none->advice);
  TypedStiffness typed{std::get<FosterForm>(std::move(form)), collector.keys()};
  refuse_own_names(typed.form, collector.leaves(), name, place);
  return typed;
}

}  // namespace vcrit
