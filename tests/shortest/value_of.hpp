// Expressions and forms as numbers.
#pragma once

#include <cmath>
#include <map>
#include <string>

#include "formula/names.hpp"
#include "shortest/expressions.hpp"
#include "shortest/shortest.hpp"

namespace vcrit::test {

using symbolic::Form;
using symbolic::Signed;

inline double value_of(const symbolic::shortest::SmallFraction& fraction) {
  return static_cast<double>(fraction.over) / static_cast<double>(fraction.under);
}

/// Of an expression; `known`: the symbols, and then what was evaluated.
inline double value_of(const symbolic::shortest::Expressions& all, symbolic::shortest::ExNode node,
                       std::map<symbolic::shortest::ExNode, double>& known) {
  using symbolic::shortest::ExpressionKind;
  if (const auto found = known.find(node); found != known.end()) return found->second;
  const auto& data = all[node];
  double value = data.kind == ExpressionKind::sum ? 0 : 1;
  for (const auto& item : data.items) {
    const double part = value_of(all, item.node, known);
    if (data.kind == ExpressionKind::sum) value += value_of(item.factor) * part;
    if (data.kind == ExpressionKind::product) value *= std::pow(part, item.exponent);
    if (data.kind == ExpressionKind::root) value = std::sqrt(value_of(item.factor) * part);
    if (data.kind == ExpressionKind::magnitude) value = std::abs(part);
  }
  if (data.kind == ExpressionKind::symbol) {
    const auto& meaning = all.meaning(node);
    value = value_of(meaning.factor) * value_of(all, meaning.node, known);
  }
  return known[node] = value;
}

/// A form with a number for an index: k[j], k[j+2] and the program's T_j as k[3], k[5] and T3.
inline Form at_number(Form form, const std::string& index, int number) {
  if (form.kind == Form::Kind::name) {
    const bool own = symbolic::is_own(form.text);
    std::string base = symbolic::base_name(form.text);
    if (const auto at = base.find("[" + index); at != std::string::npos) {
      const std::string shift = base.substr(at + 1 + index.size());
      const int by = shift == "]" ? 0 : std::stoi(shift);
      const std::string digits = std::to_string(number + by);
      base = base.substr(0, at) + (own ? digits : "[" + digits + "]");
    } else if (own && base.ends_with("_" + index)) {
      base = base.substr(0, base.size() - index.size() - 1) + std::to_string(number);
    }
    form.text = own ? symbolic::own_name(base) : base;
  }
  for (Form& part : form.over) part = at_number(part, index, number);
  for (Form& part : form.under) part = at_number(part, index, number);
  for (Signed& term : form.terms) term.form = at_number(term.form, index, number);
  return form;
}

/// Of a form with a number for each name.
inline double value_of(const Form& form, const std::map<std::string, double>& names) {
  switch (form.kind) {
    case Form::Kind::number: {
      const std::size_t bar = form.text.find('/');
      const double over = std::stod(form.text.substr(0, bar));
      return bar == std::string::npos ? over : over / std::stod(form.text.substr(bar + 1));
    }
    case Form::Kind::name:
      return names.at(form.text);
    case Form::Kind::sum: {
      double sum = 0;
      for (const Signed& term : form.terms)
        sum += (term.minus ? -1 : 1) * value_of(term.form, names);
      return sum;
    }
    case Form::Kind::product: {
      double product = 1;
      for (const Form& factor : form.over) product *= value_of(factor, names);
      for (const Form& factor : form.under) product /= value_of(factor, names);
      return product;
    }
    case Form::Kind::power:
      return std::pow(value_of(form.over[0], names), form.exponent);
    case Form::Kind::root:
      return std::sqrt(value_of(form.over[0], names));
    case Form::Kind::series: {
      double sum = 0;
      for (int number = form.exponent; number <= form.last; ++number)
        sum += value_of(at_number(form.terms[0].form, form.text, number), names);
      return sum;
    }
    case Form::Kind::call:
      break;
  }
  return std::abs(value_of(form.terms[0].form, names));
}

}  // namespace vcrit::test
