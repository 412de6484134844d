#include "network/amount.hpp"

namespace vcrit {

namespace {

bool same_expression(const AmountTreePointer& a, const AmountTreePointer& b) {
  if (a == b) return true;
  if (a == nullptr || b == nullptr || a->kind != b->kind) return false;
  if (a->kind == AmountTree::Kind::symbol) return a->symbol == b->symbol;
  if (a->kind == AmountTree::Kind::number) return a->number.decimal == b->number.decimal;
  return same_expression(a->first, b->first) && same_expression(a->second, b->second);
}

bool has_two_parts(const AmountTree& e) {
  return e.kind != AmountTree::Kind::symbol && e.kind != AmountTree::Kind::number;
}

void visit_symbols(const AmountTree& e,
                   const std::function<void(const Symbol&, NumberRole)>& visit) {
  if (e.kind == AmountTree::Kind::symbol) return visit(e.symbol, e.role);
  if (!has_two_parts(e)) return;
  visit_symbols(*e.first, visit);
  visit_symbols(*e.second, visit);
}

AmountTreePointer expression_of(const Amount& amount, NumberRole role) {
  return amount.is_symbol() ? make_expression(amount.symbol(), role) : amount.expression();
}

AmountTreePointer replaced_in(const AmountTreePointer& e,
                              const std::function<Amount(const Symbol&)>& other) {
  if (e->kind == AmountTree::Kind::symbol) return expression_of(other(e->symbol), e->role);
  if (!has_two_parts(*e)) return e;
  return make_expression(e->kind, replaced_in(e->first, other), replaced_in(e->second, other));
}

// Null where it is 0.
AmountTreePointer zeros_dropped(const AmountTreePointer& e,
                                const std::function<bool(const Symbol&)>& zero) {
  if (e->kind == AmountTree::Kind::symbol) return zero(e->symbol) ? nullptr : e;
  if (!has_two_parts(*e)) return e;
  const AmountTreePointer first = zeros_dropped(e->first, zero),
                          second = zeros_dropped(e->second, zero);
  if (first != nullptr && second != nullptr) return make_expression(e->kind, first, second);
  if (e->kind == AmountTree::Kind::sum) return first != nullptr ? first : second;
  ensure(e->kind == AmountTree::Kind::product || second != nullptr, "nothing is divided by 0");
  return nullptr;
}

bool divides(const AmountTree& e, const std::function<bool(const Symbol&)>& zero) {
  if (!has_two_parts(e)) return false;
  if (divides(*e.first, zero) || divides(*e.second, zero)) return true;
  return e.kind == AmountTree::Kind::quotient && zeros_dropped(e.second, zero) == nullptr;
}

std::size_t count_operations(const AmountTree& e) {
  if (e.kind == AmountTree::Kind::symbol) return 0;
  return 1 + (has_two_parts(e) ? count_operations(*e.first) + count_operations(*e.second) : 0);
}

std::optional<double> expression_value(const AmountTree& e, const Values& values) {
  if (e.kind == AmountTree::Kind::number) return e.number.value;
  if (e.kind == AmountTree::Kind::symbol) return amount_value(e.symbol, values);
  const auto first = expression_value(*e.first, values),
             second = expression_value(*e.second, values);
  if (!first || !second) return std::nullopt;
  if (e.kind == AmountTree::Kind::sum) return *first + *second;
  return e.kind == AmountTree::Kind::product ? *first * *second : *first / *second;
}

std::string expression_text(const AmountTree& e,
                            const std::function<std::string(const Symbol&)>& name) {
  const auto factor = [&](const AmountTree& part, bool below) {
    const bool brackets =
        part.kind == AmountTree::Kind::sum ||
        (below && part.kind != AmountTree::Kind::symbol && part.kind != AmountTree::Kind::number);
    return brackets ? "(" + expression_text(part, name) + ")" : expression_text(part, name);
  };
  switch (e.kind) {
    case AmountTree::Kind::symbol:
      return name(e.symbol);
    case AmountTree::Kind::number:
      return e.number.decimal;
    case AmountTree::Kind::sum:
      return expression_text(*e.first, name) + " + " + expression_text(*e.second, name);
    case AmountTree::Kind::product:
      return factor(*e.first, false) + "*" +
             factor(*e.second, e.second->kind == AmountTree::Kind::quotient);
    case AmountTree::Kind::quotient:
      break;
  }
  return factor(*e.first, false) + "/" + factor(*e.second, true);
}

}  // namespace

AmountTreePointer make_expression(Symbol symbol, NumberRole role) {
  AmountTree made;
  made.kind = AmountTree::Kind::symbol;
  made.symbol = std::move(symbol);
  made.role = role;
  return std::make_shared<const AmountTree>(std::move(made));
}

AmountTreePointer make_expression(TypedNumber number) {
  AmountTree made;
  made.number = std::move(number);
  return std::make_shared<const AmountTree>(std::move(made));
}

AmountTreePointer make_expression(AmountTree::Kind kind, AmountTreePointer first,
                                  AmountTreePointer second) {
  AmountTree made;
  made.kind = kind;
  made.first = std::move(first);
  made.second = std::move(second);
  return std::make_shared<const AmountTree>(std::move(made));
}

bool operator==(const Amount& a, const Amount& b) {
  return a.symbol_ == b.symbol_ && same_expression(a.expression_, b.expression_);
}

void for_each_symbol(const Amount& amount, NumberRole role,
                     const std::function<void(const Symbol&, NumberRole)>& visit) {
  if (amount.is_symbol()) return visit(amount.symbol(), role);
  visit_symbols(*amount.expression(), visit);
}

Amount with_symbols(const Amount& amount, const std::function<Amount(const Symbol&)>& other) {
  if (amount.is_symbol()) return other(amount.symbol());
  return {amount.name(), replaced_in(amount.expression(), other)};
}

std::optional<Amount> without_zeros(const Amount& amount,
                                    const std::function<bool(const Symbol&)>& zero) {
  if (amount.is_symbol()) return zero(amount.symbol()) ? std::nullopt : std::optional(amount);
  AmountTreePointer left = zeros_dropped(amount.expression(), zero);
  if (left == nullptr) return std::nullopt;
  return Amount(amount.name(), std::move(left));
}

bool divides_by_zero(const Amount& amount, const std::function<bool(const Symbol&)>& zero) {
  return !amount.is_symbol() && divides(*amount.expression(), zero);
}

std::size_t amount_operations(const Amount& amount) {
  return amount.is_symbol() ? 0 : count_operations(*amount.expression());
}

std::optional<double> amount_value(const Amount& amount, const Values& values) {
  if (!amount.is_symbol()) return expression_value(*amount.expression(), values);
  const double* const value = values.find(amount.symbol());
  return value == nullptr ? std::nullopt : std::optional(*value);
}

std::string to_text(const Amount& amount, const std::function<std::string(const Symbol&)>& name) {
  return amount.is_symbol() ? name(amount.symbol()) : expression_text(*amount.expression(), name);
}

}  // namespace vcrit
