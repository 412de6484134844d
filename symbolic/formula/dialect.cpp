#include "formula/dialect.hpp"

#include "base/interruption.hpp"
#include "formula/names.hpp"

namespace vcrit::symbolic {

std::string Dialect::print(const Signed& expression) const {
  hear_interruption();
  const std::string text = piece(expression.form).text;
  return expression.minus ? negative(text) : text;
}

std::string Dialect::equation(const Signed& left, const Signed& right) const {
  return related(print(left), false, print(right));
}

std::string Dialect::asymptote(const Signed& left, const Signed& right) const {
  return related(print(left), true, print(right));
}

std::vector<Piece> Dialect::pieces(const std::vector<Form>& forms) const {
  std::vector<Piece> result;
  for (const Form& form : forms) result.push_back(piece(form));
  return result;
}

std::vector<std::string> Dialect::factors(const std::vector<Piece>& pieces,
                                          bool lone_is_bare) const {
  std::vector<std::string> result;
  for (const Piece& each : pieces) {
    const bool bare =
        each.tightness != Piece::Tightness::sum || (lone_is_bare && pieces.size() == 1);
    result.push_back(bare ? each.text : wrapped(each.text));
  }
  return result;
}

Piece Dialect::piece(const Form& form) const {
  switch (form.kind) {
    case Form::Kind::number: {
      const bool whole = form.text.find('/') == std::string::npos;
      return {number(form.text), whole ? Piece::Tightness::atom : Piece::Tightness::product};
    }
    case Form::Kind::name:
      return {name(printed_name(form.text))};
    case Form::Kind::sum: {
      std::string text;
      for (std::size_t i = 0; i < form.terms.size(); ++i) {
        const Signed& term = form.terms[i];
        text = i == 0 ? print(term) : added(text, term.minus, piece(term.form).text);
      }
      return {text, Piece::Tightness::sum};
    }
    case Form::Kind::product:
      if (form.under.empty())
        return {product(factors(pieces(form.over), false)), Piece::Tightness::product};
      return fraction(pieces(form.over), pieces(form.under));
    case Form::Kind::power: {
      const Piece base = piece(form.over[0]);
      const bool atom = base.tightness == Piece::Tightness::atom;
      return {power(atom ? base.text : wrapped(base.text), form.exponent)};
    }
    case Form::Kind::root:
      return {root(piece(form.over[0]).text)};
    case Form::Kind::call:
      break;
  }
  return {call(form.text, print(form.terms[0]))};
}

}  // namespace vcrit::symbolic
