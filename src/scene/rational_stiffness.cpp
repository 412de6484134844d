#include "scene/rational_stiffness.hpp"

#include <fmt/core.h>

#include <charconv>
#include <string_view>
#include <utility>
#include <variant>

#include "network/expression.hpp"
#include "network/rational.hpp"
#include "scene/cursor.hpp"

namespace vcrit {

namespace {

constexpr int largest_degree = 40;  // beyond that, prony() with its own numbers
constexpr std::size_t longest_quote = 60;
constexpr int most_operations_of_stiffness = 2000;
constexpr std::size_t longest_decimal = 24;  // characters: all that doubles have, and some

// Of the coefficients of a polynomial, together: 100 factors whose numbers have 20 digits take half
// of it.
constexpr long most_bits = 1L << 21;

bool digit_or_point(char c) { return (c >= '0' && c <= '9') || c == '.'; }

class StiffnessParser : Cursor {
 public:
  using Cursor::Cursor;

  RationalFunction whole() {
    RationalFunction all = sum();
    if (!at_end()) refuse(found(), "\"+\", \"-\", \"*\", \"/\", \"^\" or the end");
    all = all.reduced();
    if (all.above.degree() > largest_degree || all.below.degree() > largest_degree) too_large();
    return all;
  }

 private:
  RationalFunction sum() {
    RationalFunction all = accept('-') ? negative(product()) : product();
    for (;;) {
      if (accept('+'))
        all = added(all, product());
      else if (accept('-'))
        all = added(all, negative(product()));
      else
        return all;
    }
  }

  RationalFunction product() {
    RationalFunction all = power();
    for (;;) {
      if (accept('*')) {
        const RationalFunction next = power();
        all = {times(all.above, next.above), times(all.below, next.below)};
      } else if (accept('/')) {
        const Place at = here();
        const RationalFunction next = power();
        if (next.above.is_zero())
          throw InputError(at, "a division by 0" + in_text(), "what is not 0");
        all = {times(all.above, next.below), times(all.below, next.above)};
      } else {
        return all;
      }
    }
  }

  RationalFunction power() {
    const RationalFunction base = operand();
    if (!accept('^')) return base;
    const int exponent = whole_exponent();
    RationalFunction all = base;
    for (int i = 1; i < exponent; ++i)
      all = {times(all.above, base.above), times(all.below, base.below)};
    return all;
  }

  RationalFunction operand() {
    const char next = peek();
    if (digit_or_point(next)) return {number(), one()};
    if (next == '(') return group();
    if (next != 's' || is_part_of_name(position_ + 1)) refuse(found(), "s, a number or \"(\"");
    ++position_;
    return {ExactPolynomial::variable(), one()};
  }

  RationalFunction group() {
    const Place opening = here();
    if (++depth_ > deepest_nesting)
      refuse("too many brackets in one another", fmt::format("at most {}", deepest_nesting));
    accept('(');
    RationalFunction inside = sum();
    if (!accept(')')) throw InputError(opening, "\"(\" without \")\"" + in_text(), "\")\"");
    --depth_;
    return inside;
  }

  ExactPolynomial number() {
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
    return ExactPolynomial(digits);
  }

  int whole_exponent() {
    const auto exponent = whole_number_up_to(largest_degree);
    if (!exponent) refuse(found(), fmt::format("a whole power from 1 to {}", largest_degree));
    return *exponent;
  }

  static ExactPolynomial one() { return ExactPolynomial("1"); }
  static RationalFunction negative(const RationalFunction& a) { return {-a.above, a.below}; }

  RationalFunction added(const RationalFunction& a, const RationalFunction& b) {
    if (a.below == b.below) return {a.above + b.above, a.below};
    return {times(a.above, b.below) + times(b.above, a.below), times(a.below, b.below)};
  }

  // Common factors are left in it until the end, hence twice the degree.
  ExactPolynomial times(const ExactPolynomial& a, const ExactPolynomial& b) {
    count();
    const long degree = a.degree() + b.degree();
    if (degree > 2 * largest_degree || (degree + 1) * (a.bits() + b.bits()) > most_bits)
      too_large();
    return a * b;
  }

  [[noreturn]] void too_large() const {
    throw InputError(place_, "a stiffness of very many terms or digits",
                     fmt::format("polynomials of degree {} at most", largest_degree),
                     "the network itself, as in prony(k0, k, tau)");
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

  int operations_ = 0, depth_ = 0;
};

}  // namespace

FosterForm read_stiffness(const std::string& text, const std::string& name, const Place& place) {
  const RationalFunction stiffness = StiffnessParser(text, place).whole();
  auto form = foster_form(stiffness, name);
  if (const auto* none = std::get_if<NoFosterForm>(&form))
    throw InputError(place, fmt::format("network \"{}\" with {}", name, none->found),
                     none->expected, none->advice);
  return std::get<FosterForm>(std::move(form));
}

}  // namespace vcrit
