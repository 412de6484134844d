#include "emit/straight_line.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "base/numbers.hpp"

namespace vcrit::symbolic {

namespace {

// Characters of an expression that is read without a name.
constexpr std::size_t longest_inline = 40;

/// What is for graphs with gaps alone.
bool is_of_gaps(const Node& node) {
  using Operation = Node::Operation;
  return node.operation == Operation::gap || node.operation == Operation::tie ||
         node.operation == Operation::tied;
}

bool is_of_table(const Node& node) {
  return node.operation == Node::Operation::place || node.operation == Node::Operation::entry;
}

/// What is computed of exact numbers, beside signs.
bool is_computed(const Node& node) {
  return node.kind != NodeKind::exact || node.operation == Node::Operation::unit ||
         is_of_gaps(node) || is_of_table(node);
}

/// A sign before a name needs no name of its own, nor does what a dialect leaves out.
bool is_too_short_to_name(const Node& node, const Operand& whole) {
  return whole.text.size() < 8 && (node.operation == Node::Operation::negate || is_of_gaps(node));
}

}  // namespace

std::string literal(double value) {
  const std::string digits = to_text(value);
  return digits.find_first_of(".e") == std::string::npos ? digits + ".0" : digits;
}

std::string in_brackets(const Operand& operand) {
  return operand.is_simple ? operand.text : "(" + operand.text + ")";
}

std::string index(const Operand& constant) {
  return constant.text.substr(0, constant.text.find('.'));
}

std::optional<Operand> by_operators(const Node& node, const std::vector<Operand>& arguments) {
  const auto text = [&](std::size_t i) { return in_brackets(arguments[i]); };
  const auto infix = [&](const char* sign) {
    return Operand{fmt::format("{} {} {}", text(0), sign, text(1)), node.kind, false};
  };
  switch (node.operation) {
    case Node::Operation::negate:
      return Operand{"-" + text(0), node.kind, false};
    case Node::Operation::add:
      return infix("+");
    case Node::Operation::subtract:
      return infix("-");
    case Node::Operation::multiply:
      return infix("*");
    case Node::Operation::divide:
      return infix("/");
    case Node::Operation::multiply_add:
      return Operand{fmt::format("{} * {} + {}", text(0), text(1), text(2)), node.kind, false};
    default:
      return std::nullopt;
  }
}

Operand StraightLine::expression(NodeId id) const {
  const auto known = known_.find(id);
  if (known != known_.end()) return known->second;
  const Node& node = program_[id];
  if (node.operation == Node::Operation::parameter)
    return {dialect_.parameter(node.parameter), NodeKind::exact, true};
  if (node.operation == Node::Operation::constant) return dialect_.constant(node);
  std::vector<Operand> arguments;
  for (std::size_t i = 0; i < arity(node.operation); ++i)
    arguments.push_back(node.kind == NodeKind::bound ? in_bound(node.arguments[i])
                                                     : expression(node.arguments[i]));
  return dialect_.apply(node, arguments);
}

// A bound needs no more of a constant than a double holds.
Operand StraightLine::in_bound(NodeId id) const {
  Node node = program_[id];
  if (node.operation != Node::Operation::constant) return expression(id);
  node.kind = NodeKind::exact;
  return dialect_.constant(node);
}

// Who uses -a uses a: the sign costs nothing in a product or sum, if a has the name.
std::map<NodeId, int> StraightLine::uses_of(const std::set<NodeId>& needed) const {
  std::map<NodeId, int> uses;
  for (auto id = needed.rbegin(); id != needed.rend(); ++id) {
    const Node& node = program_[*id];
    const int count = node.operation == Node::Operation::negate ? std::max(1, uses[*id]) : 1;
    for (std::size_t i = 0; i < arity(node.operation); ++i) uses[node.arguments[i]] += count;
  }
  return uses;
}

/// Of what the results need, what the dialect writes. A name for the rest would have no use, and
/// compilers warn of that.
std::set<NodeId> StraightLine::written_for(const std::vector<NodeId>& results) const {
  std::set<NodeId> written(results.begin(), results.end());
  for (NodeId id = program_.nodes().size(); id-- > 0;) {
    if (!written.contains(id)) continue;
    const Node& node = program_[id];
    for (std::size_t i = 0; i < arity(node.operation); ++i)
      if (dialect_.reads(node, i)) written.insert(node.arguments[i]);
  }
  return written;
}

std::vector<StraightLine::Declarations> StraightLine::declare(const std::vector<NodeId>& results) {
  const std::map<NodeId, int> uses = uses_of(program_.needed_for(results));
  const auto is_used_once = [&uses](NodeId id) { return !uses.contains(id) || uses.at(id) < 2; };
  std::vector<Declarations> declared;
  // No value depends on a bound.
  for (const bool bounds : {false, true})
    for (const NodeId id : written_for(results)) {
      const Node& node = program_[id];
      if (arity(node.operation) == 0 || known_.contains(id) ||
          (node.kind == NodeKind::bound) != bounds || !is_computed(node))
        continue;
      const Operand whole = expression(id);
      if (is_used_once(id) && whole.text.size() <= longest_inline) continue;
      if (is_too_short_to_name(node, whole)) continue;
      const std::string name = fmt::format("{}{}", bounds ? "e" : "x", ++count_);
      if (declared.empty() || declared.back().kind != node.kind)
        declared.push_back({node.kind, {}});
      declared.back().items.push_back(name + " = " + whole.text);
      known_[id] = {name, node.kind, true};
    }
  return declared;
}

}  // namespace vcrit::symbolic
