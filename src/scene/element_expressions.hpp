// Expressions in the place of values in [elements], put into one another until only numbers with
// names of their own are left: the elements that have no expression, and parameters that no network
// names. What each parameter measures follows from its unit, else from the expressions.
#pragma once

#include <toml++/toml.h>

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/errors.hpp"
#include "network/amount.hpp"
#include "scene/element_names.hpp"
#include "scene/expression_roles.hpp"

namespace vcrit {

/// What [elements] has for an element; null where it has nothing, and where there is no table.
const toml::node* element_node(const toml::table* elements, const Symbol& element);

/// Expressions that no table holds: those of the elements of a stiffness typed in.
struct GivenExpressions {
  /// The place is that of the opening quote.
  struct Text {
    std::string text;
    Place place;
  };
  std::map<Symbol, Text> texts;
  std::set<std::string> keys;  ///< of [elements], that led to them
};

class ElementExpressions {
 public:
  using Uses = ElementNames::Uses;

  /// `elements`: the table, null where there is none; `given`: others, by reference; `uses`: what
  /// the networks use, by the names of the elements. Throws InputError for an expression that
  /// contains itself, and for one that does not measure what its element is.
  ElementExpressions(const toml::table* elements, std::string file, ElementNames& names,
                     const GivenExpressions& given, const Uses& uses);

  bool has(const Symbol& element) const { return expressions_.contains(element); }
  /// What the networks have for an element: the symbol that `own` makes of it, or its expression of
  /// such symbols. Throws InputError where the expressions of all uses together grow too long.
  Amount amount(const Symbol& element, const std::function<Symbol(const Symbol&)>& own);
  /// Throws InputError for an expression that divides by what is 0 where `zero` holds for elements.
  void refuse_divisions(const std::function<bool(const Symbol&)>& zero) const;
  /// As they are written.
  const std::map<Symbol, std::string>& all() const { return texts_; }
  /// Those that the networks do not use themselves.
  const Uses& parameters() const { return parameters_; }
  /// Whether an expression of the networks' elements leads to this key.
  bool is_used(const std::string& key) const { return keys_.contains(key); }

 private:
  using Text = GivenExpressions::Text;
  struct Written {
    Amount amount;
    Text written;
    NumberMeasure measure;
    std::size_t operations = 0;
  };

  void read(const Symbol& element, const ElementUse& use);
  AmountTreePointer resolved(const Symbol& element);
  AmountTreePointer put_in(const AmountTreePointer& expression, const Text& written);
  AmountTreePointer put_in(const Symbol& name, const Text& written);
  void find_roles(const Uses& uses);
  AmountTreePointer with_roles(const AmountTreePointer& expression,
                               const std::map<std::string, NumberMeasure>& measures) const;
  [[noreturn]] void refuse_circle(const Symbol& element) const;
  int length_of(const Symbol& leaf, const Uses& uses) const;
  std::optional<Text> text_of(const Symbol& element) const;

  const toml::table* elements_;
  std::string file_;
  ElementNames& names_;
  const GivenExpressions& given_;
  std::map<Symbol, Written> expressions_;
  std::map<Symbol, AmountTreePointer> resolved_;
  std::map<Symbol, Amount> made_;    // for the networks
  std::size_t operations_ = 0;       // of all expressions
  std::size_t operations_used_ = 0;  // of all their uses
  std::vector<Symbol> way_;          // those that are being resolved
  std::map<Symbol, Place> leaves_;   // with an expression that names each
  std::map<Symbol, std::string> texts_;
  Uses parameters_;
  std::set<std::string> keys_;
};

}  // namespace vcrit
