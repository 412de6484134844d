#include "scene/element_expressions.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "base/joined.hpp"
#include "network/law.hpp"
#include "scene/arithmetic.hpp"
#include "scene/document.hpp"
#include "scene/expression_roles.hpp"
#include "scene/quantities.hpp"

namespace vcrit {

namespace {

bool holds_expression(const toml::node& value) {
  const auto* array = value.as_array();
  if (array == nullptr) return expression_in(value).has_value();
  return std::any_of(array->begin(), array->end(),
                     [](const toml::node& entry) { return expression_in(entry).has_value(); });
}

// Of one scene; with those that they are made of.
constexpr std::size_t most_operations_of_all = 1'000'000;
// Of its networks, which are carried out wherever an element is used.
constexpr std::size_t most_operations_used = 4'000'000;

bool per_length(const ElementUse& use) {
  const NumberRow& row = number_row(use.role);
  return use.dimension != row.dimension;
}

/// By what its networks use: relaxation times alone tell nothing.
MeasuredParts parts_used_by(const ElementNames::Uses& uses) {
  bool half_space = false, networks = false;
  for (const auto& [name, use] : uses) {
    const NumberRow& row = number_row(use.role);
    if (row.dimension == row.in_half_space) continue;
    (per_length(use) ? half_space : networks) = true;
  }
  if (half_space) return networks ? MeasuredParts::both : MeasuredParts::half_space;
  return MeasuredParts::networks;
}

// Behind a number.
bool has_unit(const std::string& text) {
  const std::size_t end = text.find_first_not_of("0123456789.+-eE \t");
  return end != text.npos;
}

/// What the unit of a parameter says that it is; nothing for a number without one. Throws
/// InputError for a unit of something else.
std::optional<NumberMeasure> measure_by_unit(const std::string& name, const toml::node& value,
                                             const Place& place, MeasuredParts parts) {
  if (!value.is_string() || !has_unit(value.ref<std::string>())) return std::nullopt;
  std::vector<std::string> expected;
  for (const NumberMeasure& measure : measures_in(parts)) {
    try {
      parse_typed(value.ref<std::string>(), measure.dimension, place);
      return measure;
    } catch (const InputError&) {
      expected.push_back(describe(measure.dimension));
    }
  }
  throw InputError(place, fmt::format("{} = {}", name, document::describe_node(value)),
                   fmt::format("one of {}", joined(expected, ", ")));
}

}  // namespace

ElementExpressions::ElementExpressions(const toml::table* elements, std::string file,
                                       ElementNames& names, const GivenExpressions& given,
                                       const Uses& uses)
    : elements_(elements), file_(std::move(file)), names_(names), given_(given), keys_(given.keys) {
  const bool holds_none =
      elements == nullptr || std::none_of(elements->begin(), elements->end(), [](const auto& each) {
        return holds_expression(each.second);
      });
  if (holds_none && given.texts.empty()) return;
  for (const auto& [name, use] : uses) {
    if (use.length == 0) read({name}, use);
    for (int entry = 1; entry <= use.length; ++entry) read({name, entry}, use);
  }
  find_roles(uses);
}

const toml::node* element_node(const toml::table* elements, const Symbol& element) {
  const toml::node* value = elements == nullptr ? nullptr : elements->get(element.name);
  if (value == nullptr || !value->is_array()) return element.entry == 0 ? value : nullptr;
  const auto place = static_cast<std::size_t>(element.entry);
  const bool is_there = place >= 1 && place <= value->as_array()->size();
  return is_there ? value->as_array()->get(place - 1) : nullptr;
}

std::optional<ElementExpressions::Text> ElementExpressions::text_of(const Symbol& element) const {
  if (const auto given = given_.texts.find(element); given != given_.texts.end())
    return given->second;
  const toml::node* node = element_node(elements_, element);
  const auto text = node == nullptr ? std::nullopt : expression_in(*node);
  if (!text) return std::nullopt;
  return Text{*text, document::place_of(*node, file_)};
}

void ElementExpressions::read(const Symbol& element, const ElementUse& use) {
  const auto written = text_of(element);
  if (!written) return;
  texts_[element] = written->text;
  const Amount amount(element, resolved(element));
  const std::size_t operations = amount_operations(amount);
  operations_ += operations;
  if (operations_ > most_operations_of_all)
    throw InputError(written->place,
                     fmt::format("expressions of more than {} operations", most_operations_of_all),
                     "fewer or shorter ones");
  expressions_[element] = {amount, *written, {use.role, use.dimension}, operations};
}

AmountTreePointer ElementExpressions::resolved(const Symbol& element) {
  if (const auto known = resolved_.find(element); known != resolved_.end()) return known->second;
  const Text written = *text_of(element);
  const bool circle = std::find(way_.begin(), way_.end(), element) != way_.end();
  way_.push_back(element);
  if (circle) refuse_circle(element);
  // The place is that of the opening quote.
  const Place& place = written.place;
  const AmountTreePointer parsed =
      parse_arithmetic(written.text, {place.file, place.line, place.column + 1});
  const AmountTreePointer whole = put_in(parsed, written);
  if (amount_operations(Amount(element, whole)) > most_operations_of_one)
    throw InputError(
        place,
        fmt::format("{} = \"{}\", of too many operations with those that it is made of",
                    to_text(element), written.text),
        fmt::format("at most {}", most_operations_of_one));
  way_.pop_back();
  return resolved_[element] = whole;
}

void ElementExpressions::refuse_circle(const Symbol& element) const {
  std::vector<std::string> ways;
  for (auto each = std::find(way_.begin(), way_.end(), element); each != way_.end(); ++each)
    ways.push_back(fmt::format("{} (line {})", to_text(*each), text_of(*each)->place.line));
  throw InputError(text_of(element)->place,
                   fmt::format("expressions in a circle: {}", joined(ways, " -> ")),
                   "a value for one of them");
}

AmountTreePointer ElementExpressions::put_in(const AmountTreePointer& expression,
                                             const Text& written) {
  switch (expression->kind) {
    case AmountTree::Kind::number:
      return expression;
    case AmountTree::Kind::symbol:
      return put_in(expression->symbol, written);
    case AmountTree::Kind::sum:
    case AmountTree::Kind::product:
    case AmountTree::Kind::quotient:
      break;
  }
  return make_expression(expression->kind, put_in(expression->first, written),
                         put_in(expression->second, written));
}

AmountTreePointer ElementExpressions::put_in(const Symbol& name, const Text& written) {
  keys_.insert(name.name);
  const Symbol element = names_.of(name);
  if (text_of(element)) {
    keys_.insert(element.name);
    return resolved(element);
  }
  leaves_.try_emplace(element, written.place);
  return make_expression(element, NumberRole::factor);
}

// An array by its entries, others by their name.
int ElementExpressions::length_of(const Symbol& leaf, const Uses& uses) const {
  const auto use = uses.find(leaf.name);
  const toml::node* node = elements_ == nullptr ? nullptr : elements_->get(leaf.name);
  int length = use == uses.end() ? 0 : use->second.length;
  if (use == uses.end() && node != nullptr && node->is_array())
    length = static_cast<int>(node->as_array()->size());
  if ((length == 0) != (leaf.entry == 0) || leaf.entry > length)
    throw InputError(
        leaves_.at(leaf), fmt::format("\"{}\" in an expression", to_text(leaf)),
        length == 0 ? fmt::format("\"{}\", which is no array", leaf.name)
                    : fmt::format("an entry of that array, {0}[1] to {0}[{1}]", leaf.name, length));
  return length;
}

void ElementExpressions::find_roles(const Uses& uses) {
  const MeasuredParts parts = parts_used_by(uses);
  std::map<std::string, NumberMeasure> measures;
  for (const auto& [leaf, place] : leaves_) {
    length_of(leaf, uses);
    if (const auto use = uses.find(leaf.name); use != uses.end())
      measures.emplace(leaf.name, NumberMeasure{use->second.role, use->second.dimension});
    else if (const toml::node* node = element_node(elements_, leaf))
      if (const auto measure =
              measure_by_unit(to_text(leaf), *node, document::place_of(*node, file_), parts))
        measures.emplace(leaf.name, *measure);
  }
  std::vector<MeasuredExpression> all;
  for (const auto& [element, written] : expressions_)
    all.push_back({to_text(element), written.written.text, written.written.place,
                   written.amount.expression(), written.measure});
  measures = measures_of_names(all, std::move(measures), parts);
  for (auto& [element, written] : expressions_)
    written.amount = Amount(element, with_roles(written.amount.expression(), measures));
  for (const auto& [leaf, place] : leaves_) {
    if (uses.contains(leaf.name) || !measures.contains(leaf.name)) continue;
    const auto& [role, dimension] = measures.at(leaf.name);
    parameters_.try_emplace(leaf.name, ElementUse{role, dimension, length_of(leaf, uses), place});
  }
}

Amount ElementExpressions::amount(const Symbol& element,
                                  const std::function<Symbol(const Symbol&)>& own) {
  const auto found = expressions_.find(element);
  if (found == expressions_.end()) return own(element);
  operations_used_ += found->second.operations;
  if (operations_used_ > most_operations_used)
    throw InputError(found->second.written.place,
                     fmt::format("expressions of more than {} operations, each use counted",
                                 most_operations_used),
                     "fewer elements that are made of others");
  const auto [known, is_new] = made_.try_emplace(element);
  if (is_new)
    known->second = with_symbols(found->second.amount,
                                 [&own](const Symbol& part) { return Amount(own(part)); });
  return known->second;
}

void ElementExpressions::refuse_divisions(const std::function<bool(const Symbol&)>& zero) const {
  for (const auto& [element, expression] : expressions_)
    if (divides_by_zero(expression.amount, zero))
      throw InputError(
          expression.written.place,
          fmt::format("{} = \"{}\", a division by 0", to_text(element), expression.written.text),
          "divisors above 0");
}

AmountTreePointer ElementExpressions::with_roles(
    const AmountTreePointer& expression,
    const std::map<std::string, NumberMeasure>& measures) const {
  if (expression->kind == AmountTree::Kind::number) return expression;
  if (expression->kind == AmountTree::Kind::symbol)
    return make_expression(expression->symbol, measures.at(expression->symbol.name).role);
  return make_expression(expression->kind, with_roles(expression->first, measures),
                         with_roles(expression->second, measures));
}

}  // namespace vcrit
