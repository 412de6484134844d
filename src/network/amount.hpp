// Numbers of elements: names, and expressions of names.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "base/errors.hpp"
#include "base/units.hpp"
#include "network/symbol.hpp"
#include "network/values.hpp"

namespace vcrit {

/// What a number measures. factor: a plain number, as in "r*k0".
enum class NumberRole { stiffness, damping, time, mass, loss_factor, factor };

struct AmountTree;
using AmountTreePointer = std::shared_ptr<const AmountTree>;

/// A number made of others by + * and / alone, so that it is positive where they are. Never changed
/// once it is made.
struct AmountTree {
  enum class Kind { symbol, number, sum, product, quotient };
  Kind kind = Kind::number;
  Symbol symbol = {};                         ///< of a symbol
  NumberRole role = NumberRole::factor;       ///< of a symbol
  TypedNumber number = {1, "1"};              ///< of a number, above 0, with its decimal
  AmountTreePointer first = {}, second = {};  ///< the terms, the factors, what is above and below
};

AmountTreePointer make_expression(Symbol symbol, NumberRole role);
AmountTreePointer make_expression(TypedNumber number);
AmountTreePointer make_expression(AmountTree::Kind kind, AmountTreePointer first,
                                  AmountTreePointer second);

/// A number of an element: that of a symbol, or an expression of symbols. Cheap to copy.
class Amount {
 public:
  Amount() = default;  ///< none: some elements have one number alone
  // NOLINTBEGIN(google-explicit-constructor): a symbol is an amount
  Amount(Symbol symbol) : symbol_(std::move(symbol)) {}
  Amount(std::string name, int entry = 0) : symbol_{std::move(name), entry} {}
  Amount(const char* name, int entry = 0) : symbol_{name, entry} {}
  /// Throws Bug for an expression.
  operator const Symbol&() const { return symbol(); }
  // NOLINTEND(google-explicit-constructor)
  /// `name`: what the scene calls the expression; it may have no name.
  Amount(Symbol name, AmountTreePointer expression)
      : symbol_(std::move(name)), expression_(std::move(expression)) {}

  bool exists() const { return expression_ != nullptr || !symbol_.name.empty(); }
  bool is_symbol() const { return expression_ == nullptr; }
  /// Throws Bug for an expression.
  const Symbol& symbol() const {
    ensure(is_symbol(), "an expression is no symbol");
    return symbol_;
  }
  const Symbol& name() const { return symbol_; }
  const AmountTreePointer& expression() const { return expression_; }  ///< null for a symbol

  /// The same name and, wherever it stands, the same expression of the same symbols.
  friend bool operator==(const Amount& a, const Amount& b);

 private:
  Symbol symbol_;
  AmountTreePointer expression_;
};

/// Calls `visit` for every symbol, in the order of writing; `role`: of the amount itself.
void for_each_symbol(const Amount& amount, NumberRole role,
                     const std::function<void(const Symbol&, NumberRole)>& visit);

/// With other amounts in the place of its symbols.
Amount with_symbols(const Amount& amount, const std::function<Amount(const Symbol&)>& other);

/// Without the symbols for which `zero` holds; nothing where it is 0 then. Throws Bug
/// where it divides by zero.
std::optional<Amount> without_zeros(const Amount& amount,
                                    const std::function<bool(const Symbol&)>& zero);

/// Whether something in it is divided by what is 0 where `zero` holds for symbols.
bool divides_by_zero(const Amount& amount, const std::function<bool(const Symbol&)>& zero);

/// How many sums, products, quotients and numbers it has; 0 for a symbol.
std::size_t amount_operations(const Amount& amount);

/// Its value in doubles; nothing where a symbol has none.
std::optional<double> amount_value(const Amount& amount, const Values& values);

/// "2*k0*(tau + t1)", by these names.
std::string to_text(
    const Amount& amount, const std::function<std::string(const Symbol&)>& name =
                              [](const Symbol& s) { return to_text(s); });

}  // namespace vcrit
