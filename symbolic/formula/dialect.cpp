#include "formula/dialect.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "base/interruption.hpp"
#include "formula/names.hpp"

namespace vcrit::symbolic {

std::string Dialect::print(const Signed& expression) const {
  return printed(expression, Position::free);
}

std::string Dialect::printed(const Signed& expression, Position place) const {
  hear_interruption();
  const std::string text = behind_sign(expression, place);
  return expression.minus ? negative(text) : text;
}

std::string Dialect::behind_sign(const Signed& term, Position place) const {
  const std::string text = piece(term.form, place).text;
  return term.minus && term.form.kind == Form::Kind::sum ? wrapped(text) : text;
}

std::string Dialect::written(const Statement& statement) const {
  const std::string left = print(statement.left);
  switch (statement.relation) {
    case Statement::Relation::none:
      return left;
    case Statement::Relation::tends:
      return tending(left, print(statement.right));
    default:
      return related(left, statement.relation == Statement::Relation::asymptotic,
                     print(statement.right));
  }
}

std::string Dialect::series(const std::string& term, const std::string& index, int first,
                            int last) const {
  return fmt::format("sum({}, {} = {}..{})", term, index, first, last);
}

std::string Dialect::equation(const Signed& left, const Signed& right) const {
  return related(print(left), false, print(right));
}

std::string Dialect::terms(const std::vector<Signed>& terms, bool go_on) const {
  std::string text = go_on ? nothing() : print(terms.front());
  for (const Signed& term : terms)
    if (go_on || &term != &terms.front())
      text = added(text, term.minus, behind_sign(term, Position::free));
  return text;
}

std::string Dialect::sign(Statement::Relation relation) const {
  return related("", relation == Statement::Relation::asymptotic, "");
}

std::string Dialect::range(const std::string& index, int first, int last) const {
  return fmt::format("{} = {}..{}", index, first, last);
}

std::vector<PrintedPart> Dialect::pieces(const std::vector<Form>& forms, Position place) const {
  std::vector<PrintedPart> result;
  for (const Form& form : forms) result.push_back(piece(form, place));
  return result;
}

PrintedPart Dialect::slashed(const std::vector<PrintedPart>& over,
                             const std::vector<PrintedPart>& under,
                             const std::string& slash) const {
  const bool lone = under.size() == 1 && under[0].tightness == PrintedPart::Tightness::atom;
  const std::string below = product(factors(under, true));
  return {product(factors(over, false)) + slash + (lone ? below : wrapped(below)),
          PrintedPart::Tightness::product};
}

std::vector<std::string> Dialect::factors(const std::vector<PrintedPart>& pieces,
                                          bool lone_is_bare) const {
  std::vector<std::string> result;
  for (const PrintedPart& each : pieces) {
    const bool bare =
        each.tightness != PrintedPart::Tightness::sum || (lone_is_bare && pieces.size() == 1);
    result.push_back(bare ? each.text : wrapped(each.text));
  }
  return result;
}

PrintedPart Dialect::quotient(const Form& form, Position place) const {
  const std::vector<PrintedPart> under = pieces(form.under, Position::in_fraction);
  if (place == Position::in_fraction)
    return inner_fraction(pieces(form.over, Position::in_fraction), under);
  const auto is_root = [](const Form& factor) { return factor.kind == Form::Kind::root; };
  if (!roots_stand_behind() || form.over.empty() || !is_root(form.over.back()))
    return fraction(pieces(form.over, Position::in_fraction), under);
  const auto roots = std::find_if(form.over.begin(), form.over.end(), is_root);
  std::vector<PrintedPart> parts{
      fraction(pieces({form.over.begin(), roots}, Position::in_fraction), under)};
  for (PrintedPart& root : pieces({roots, form.over.end()}, Position::free))
    parts.push_back(std::move(root));
  return {product(factors(parts, false)), PrintedPart::Tightness::product};
}

PrintedPart Dialect::piece(const Form& form, Position place) const {
  switch (form.kind) {
    case Form::Kind::number: {
      const bool whole = form.text.find('/') == std::string::npos;
      return {number(form.text),
              whole ? PrintedPart::Tightness::atom : PrintedPart::Tightness::product};
    }
    case Form::Kind::name:
      if (form.text == own_name("infinity")) return {infinity()};
      return {name(form.text)};
    case Form::Kind::sum: {
      std::string text;
      for (std::size_t i = 0; i < form.terms.size(); ++i) {
        const Signed& term = form.terms[i];
        text = i == 0 ? printed(term, place) : added(text, term.minus, behind_sign(term, place));
      }
      return {text, PrintedPart::Tightness::sum};
    }
    case Form::Kind::product:
      if (form.under.empty())
        return {product(factors(pieces(form.over, place), false)), PrintedPart::Tightness::product};
      return quotient(form, place);
    case Form::Kind::power: {
      const PrintedPart base = piece(form.over[0], place);
      const bool atom = base.tightness == PrintedPart::Tightness::atom;
      return {power(atom ? base.text : wrapped(base.text), form.exponent)};
    }
    case Form::Kind::root:
      return {root(piece(form.over[0], place).text)};
    case Form::Kind::series:
      return {series(factors({piece(form.terms[0].form, place)}, false)[0], form.text,
                     form.exponent, form.last),
              series_tightness()};
    case Form::Kind::call:
      break;
  }
  return {call(form.text, printed(form.terms[0], place))};
}

}  // namespace vcrit::symbolic
