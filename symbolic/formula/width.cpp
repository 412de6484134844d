#include "formula/width.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <string>
#include <string_view>

#include "formula/dialect.hpp"

namespace vcrit::symbolic {

namespace {

/// How deep in fractions and indices: letters of 10, 7 and 5 pt. Small letters are wider for their
/// height.
enum class Style { display, text, script, scriptscript };

double scale(Style style) {
  return style == Style::script ? 0.8 : style == Style::scriptscript ? 0.7 : 1;
}
Style within_bar(Style style) {
  return style == Style::display ? Style::text
         : style == Style::text  ? Style::script
                                 : Style::scriptscript;
}
Style raised(Style style) { return style <= Style::text ? Style::script : Style::scriptscript; }

// cmmi10, a to z and A to Z, with italic correction.
constexpr std::array<double, 26> small_letters{5.3, 4.3, 4.4, 5.3, 4.7, 6.0, 5.2, 5.8, 3.5,
                                               4.8, 5.6, 3.1, 8.8, 6.1, 4.9, 5.1, 4.9, 4.9,
                                               4.7, 3.7, 5.8, 5.3, 7.5, 5.8, 5.3, 5.2};
constexpr std::array<double, 26> capitals{7.6, 8.1, 7.9, 8.4,  8.0,  7.9, 7.9, 9.2, 5.2,
                                          6.6, 9.3, 6.9, 10.9, 9.2,  7.9, 7.9, 8.0, 7.7,
                                          6.8, 7.3, 8.0, 8.1,  10.9, 9.1, 8.2, 7.6};
constexpr double digit = 5.0, roman_width = 5.6, greek_width = 6.6, capital_width = 8.4;

double letter_width(char c, bool roman) {
  if (std::isdigit(static_cast<unsigned char>(c)) != 0) return digit;
  if (c == 'm' || c == 'w') return 8.8;
  if (roman && std::isupper(static_cast<unsigned char>(c)) != 0) return capital_width;
  if (roman) return roman_width;
  if (c >= 'a' && c <= 'z') return small_letters.at(static_cast<std::size_t>(c - 'a'));
  if (c >= 'A' && c <= 'Z') return capitals.at(static_cast<std::size_t>(c - 'A'));
  return c == ',' ? 4.5 : c == '\'' || c == '|' ? 2.8 : roman_width;
}

/// Of a name as the LaTeX dialect writes it: letters, \commands, {groups}, indices and exponents.
class NameWidth {
 public:
  explicit NameWidth(std::string_view latex) : left_(latex) {}

  double of(Style style, bool roman = false) {
    double sum = 0;
    while (!left_.empty() && left_.front() != '}') sum += part(style, roman);
    return sum;
  }

 private:
  double part(Style style, bool roman) {
    const char c = left_.front();
    if (c == '\\') return command(style, roman);
    left_.remove_prefix(1);
    if (c == ' ') return 0;
    if (c == '_' || c == '^') return 0.5 + (left_.empty() ? 0 : part(raised(style), roman));
    if (c != '{') return letter_width(c, roman) * scale(style);
    return group(style, roman);
  }

  double group(Style style, bool roman) {
    const double inside = of(style, roman);
    if (!left_.empty()) left_.remove_prefix(1);
    return inside;
  }

  double command(Style style, bool roman) {
    std::size_t end = 1;
    while (end < left_.size() && std::isalpha(static_cast<unsigned char>(left_[end])) != 0) ++end;
    const std::string_view name = left_.substr(1, end - 1);
    left_.remove_prefix(std::max<std::size_t>(end, 2));
    if (name == "mathrm" || name == "dot" || name == "ddot") {
      if (left_.empty()) return 0;
      return part(style, name == "mathrm" || roman);
    }
    return (name == "Delta" ? capital_width : name.empty() ? digit : greek_width) * scale(style);
  }

  std::string_view left_;
};

class FormWidth {
 public:
  double of(const Form& form, Style style) const {
    switch (form.kind) {
      case Form::Kind::number:
        return number(form.text, style);
      case Form::Kind::name:
        return NameWidth(latex_dialect().print({false, form})).of(style);
      case Form::Kind::sum:
        return sum(form.terms, style);
      case Form::Kind::product:
        return product(form, style);
      case Form::Kind::power:
        return (of(form.over[0], style) + around(form.over[0])) +
               digit * scale(raised(style)) * static_cast<double>(1 + form.exponent / 10) + 1;
      case Form::Kind::root:
        return of(form.over[0], style) + 10.5;
      case Form::Kind::series:
        return 26 + of(form.terms[0].form, style) + around(form.terms[0].form);
      case Form::Kind::call:
        break;
    }
    const double inside = of(form.terms[0], style);
    if (form.text == "abs") return inside + 10;
    return inside + 24 +
           (form.text == "exp" ? 0 : roman_width * static_cast<double>(form.text.size()));
  }

  double of(const Signed& expression, Style style) const {
    return (expression.minus ? width_of_sign * scale(style) : 0) + of(expression.form, style);
  }

 private:
  static double number(const std::string& digits, Style style) {
    const std::size_t bar = digits.find('/');
    if (bar == std::string::npos) return digit * scale(style) * static_cast<double>(digits.size());
    const std::size_t longer = std::max(bar, digits.size() - bar - 1);
    return 2.6 + digit * scale(within_bar(style)) * static_cast<double>(longer);
  }

  double sum(const std::vector<Signed>& terms, Style style) const {
    double result = 0;
    for (const Signed& term : terms)
      result += of(term.form, style) +
                (&term != &terms.front() || term.minus ? width_of_sign * scale(style) : 0);
    return result;
  }

  /// Parentheses, with the space outside.
  static double around(const Form& form) {
    const bool loose = form.kind == Form::Kind::sum || form.kind == Form::Kind::series;
    return loose ? 18 : form.kind == Form::Kind::product ? 18 : 0;
  }

  double factors(const std::vector<Form>& factors, bool lone_is_bare, Style style) const {
    double result = factors.empty() ? digit : 0;
    for (const Form& each : factors) {
      const bool bare = each.kind == Form::Kind::product || (lone_is_bare && factors.size() == 1);
      result += of(each, style) + (bare ? 1.7 : around(each));
    }
    return result;
  }

  /// over/under, as it is written within a fraction.
  double on_one_line(const Form& form, Style style) const {
    const bool lone = form.under.size() == 1 && form.under[0].kind != Form::Kind::sum &&
                      form.under[0].kind != Form::Kind::series;
    return factors(form.over, false, style) + digit * scale(style) +
           factors(form.under, true, style) + (lone ? 0 : 18);
  }

  double product(const Form& form, Style style) const {
    if (form.under.empty()) return factors(form.over, false, style);
    if (style != Style::display) return on_one_line(form, style);
    const Style inner = within_bar(style);
    std::vector<Form> over = form.over;
    double roots = 0;
    while (!over.empty() && over.back().kind == Form::Kind::root) {
      roots += of(over.back(), style);
      over.pop_back();
    }
    return 4 + roots + std::max(factors(over, true, inner), factors(form.under, true, inner));
  }
};

}  // namespace

double width_of(const Form& form) { return FormWidth().of(form, Style::display); }

double width_of(const Signed& expression) { return FormWidth().of(expression, Style::display); }

double width_of(const Statement& statement) {
  const double left = width_of(statement.left);
  if (statement.relation == Statement::Relation::none) return left;
  return left + width_of_relation + width_of(statement.right);
}

}  // namespace vcrit::symbolic
