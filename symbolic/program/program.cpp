#include "program/program.hpp"

#include <algorithm>
#include <cstdlib>

#include "base/errors.hpp"
#include "formula/symbols.hpp"

namespace vcrit::symbolic {

namespace {

// Exact fractions beyond this size gain nothing: the literals have 107 bits.
constexpr int longest_fold = 4000;

bool is_short(const GiNaC::numeric& x) {
  return x.numer().int_length() + x.denom().int_length() < longest_fold;
}

bool is_moderate(const GiNaC::numeric& x) {
  return std::abs(x.numer().int_length() - x.denom().int_length()) < 199;
}

// Beyond this, only numbers with an exponent of their own can hold it: left to them.
bool is_ordinary(const GiNaC::numeric& x) {
  return x.is_zero() || std::abs(x.numer().int_length() - x.denom().int_length()) < 900;
}

bool is_double(const GiNaC::numeric& x) { return exact_binary(x.to_double()) == x; }

}  // namespace

std::size_t arity(Node::Operation operation) {
  using Operation = Node::Operation;
  switch (operation) {
    case Operation::parameter:
    case Operation::constant:
      return 0;
    case Operation::negate:
    case Operation::root:
    case Operation::unit:
    case Operation::magnitude:
    case Operation::size:
    case Operation::unless_moderate:
    case Operation::place:
      return 1;
    case Operation::multiply_add:
    case Operation::less_inertia:
    case Operation::gap:
    case Operation::tie:
    case Operation::tied:
      return 3;
    default:
      return 2;
  }
}

NodeId Program::push(Node node) {
  nodes_.push_back(std::move(node));
  return nodes_.size() - 1;
}

NodeId Program::parameter(const Symbol& symbol) {
  const auto known = parameters_.find(symbol);
  if (known != parameters_.end()) return known->second;
  return parameters_[symbol] = push({Operation::parameter, NodeKind::exact, {}, 0, symbol, {}});
}

NodeId Program::constant(const GiNaC::numeric& value) {
  const auto known = constants_.find(value);
  if (known != constants_.end()) return known->second;
  const NodeKind kind = is_double(value) ? NodeKind::exact : NodeKind::value;
  return constants_[value] = push({Operation::constant, kind, {}, value, {}, {}});
}

bool Program::has(Operation operation) const {
  return std::any_of(nodes_.begin(), nodes_.end(),
                     [&](const Node& node) { return node.operation == operation; });
}

bool Program::is_constant(NodeId id) const { return nodes_[id].operation == Operation::constant; }

bool Program::is_negated(NodeId id) const { return nodes_[id].operation == Operation::negate; }

bool Program::is_constant(NodeId id, int value) const {
  return is_constant(id) && nodes_[id].constant == value;
}

NodeId Program::apply(Operation operation, std::array<NodeId, 3> arguments) {
  const Key key{operation, arguments};
  const auto known = known_.find(key);
  if (known != known_.end()) return known->second;
  NodeKind kind = NodeKind::value;
  for (std::size_t i = 0; i < arity(operation); ++i)
    if (nodes_[arguments[i]].kind == NodeKind::bound) kind = NodeKind::bound;
  if (operation == Operation::size || operation == Operation::unless_moderate)
    kind = NodeKind::bound;
  if (operation == Operation::unit || operation == Operation::gap || operation == Operation::tie ||
      operation == Operation::place || operation == Operation::entry)
    kind = NodeKind::exact;
  if (operation == Operation::negate || operation == Operation::magnitude ||
      operation == Operation::tied)
    kind = nodes_[arguments[0]].kind;
  return known_[key] = push({operation, kind, arguments, 0, {}, {}});
}

std::optional<NodeId> Program::fold(NodeId a, NodeId b, const Fold& operation) {
  if (!is_constant(a) || !is_constant(b) || !is_short(value(a)) || !is_short(value(b)))
    return std::nullopt;
  const GiNaC::numeric result = operation(value(a), value(b));
  return is_ordinary(result) ? std::optional(constant(result)) : std::nullopt;
}

// Signs are kept outside of products and sums, where they cost nothing: multiply_adds take them.
NodeId Program::negate(NodeId a) {
  if (is_constant(a)) return constant(-value(a));
  if (is_negated(a)) return nodes_[a].arguments[0];
  return apply(Operation::negate, {a});
}

NodeId Program::add(NodeId a, NodeId b) {
  if (is_constant(a, 0)) return b;
  if (is_constant(b, 0)) return a;
  if (const auto folded = fold(a, b, std::plus<>())) return *folded;
  if (is_negated(a) && is_negated(b)) return negate(add(negate(a), negate(b)));
  for (const auto& [product, other] : {std::pair(b, a), std::pair(a, b)}) {
    const Node& node = nodes_[is_negated(product) ? negate(product) : product];
    if (node.operation != Operation::multiply || node.kind != NodeKind::value) continue;
    const auto [first, second, none] = node.arguments;
    return multiply_add(is_negated(product) ? negate(first) : first, second, other);
  }
  if (is_negated(b)) return apply(Operation::subtract, {a, negate(b)});
  if (is_negated(a)) return apply(Operation::subtract, {b, negate(a)});
  return apply(Operation::add, {a, b});
}

NodeId Program::multiply(NodeId a, NodeId b) {
  if (is_constant(a, 0) || is_constant(b, 1)) return a;
  if (is_constant(b, 0) || is_constant(a, 1)) return b;
  if (const auto folded = fold(a, b, std::multiplies<>())) return *folded;
  if (is_constant(a, -1)) return negate(b);
  if (is_constant(b, -1)) return negate(a);
  if (is_negated(a)) return negate(multiply(negate(a), b));
  if (is_negated(b)) return negate(multiply(a, negate(b)));
  return apply(Operation::multiply, {a, b});
}

NodeId Program::divide(NodeId a, NodeId b) {
  if (is_constant(a, 0) || is_constant(b, 1)) return a;
  if (!is_constant(b, 0))
    if (const auto folded = fold(a, b, std::divides<>())) return *folded;
  return apply(Operation::divide, {a, b});
}

NodeId Program::multiply_add(NodeId a, NodeId b, NodeId c) {
  const bool trivial = is_constant(a, 0) || is_constant(b, 0) || is_constant(c, 0) ||
                       is_constant(a, 1) || is_constant(b, 1) || is_constant(a, -1) ||
                       is_constant(b, -1) || (is_constant(a) && is_constant(b));
  if (trivial) return add(multiply(a, b), c);
  if (is_negated(b)) return multiply_add(negate(a), negate(b), c);
  if (is_negated(a) && is_negated(c)) return negate(multiply_add(negate(a), b, negate(c)));
  return apply(Operation::multiply_add, {a, b, c});
}

NodeId Program::less_inertia(NodeId k, NodeId m, NodeId omega) {
  for (const NodeId id : {k, m, omega})
    ensure(nodes_[id].kind == NodeKind::exact, "less_inertia takes numbers as they were given");
  return apply(Operation::less_inertia, {k, m, omega});
}

NodeId Program::root(NodeId a) { return apply(Operation::root, {a}); }

NodeId Program::unit(NodeId a) { return apply(Operation::unit, {a}); }

NodeId Program::nonzero(NodeId a, NodeId b) {
  return is_constant(a) && !is_constant(a, 0) ? a : apply(Operation::nonzero, {a, b});
}

NodeId Program::gaps(const std::vector<std::pair<NodeId, NodeId>>& edges) {
  ensure(edges.size() <= most_edges, "each edge has a digit");
  NodeId whole = constant(0);
  for (const auto& [re, im] : edges) whole = apply(Operation::gap, {whole, re, im});
  return whole;
}

NodeId Program::tie(NodeId gaps, std::size_t edge, const std::string& wiring) {
  auto known = std::find(wirings_.begin(), wirings_.end(), wiring);
  if (known == wirings_.end()) known = wirings_.insert(known, wiring);
  const NodeId graph = constant(static_cast<int>(known - wirings_.begin()));
  const NodeId id = apply(Operation::tie, {gaps, constant(static_cast<int>(edge)), graph});
  nodes_[id].wiring = wiring;
  return id;
}

// Factor by factor, so that products stay where sums can take them in.
NodeId Program::tied(NodeId a, NodeId tie, int otherwise) {
  if (is_constant(a, otherwise)) return a;
  if (is_negated(a) && otherwise == 0) return negate(tied(negate(a), tie, 0));
  const Node& node = nodes_[a];
  if (node.operation != Operation::multiply)
    return apply(Operation::tied, {a, tie, constant(otherwise)});
  const auto [first, second, none] = node.arguments;
  const NodeId left = tied(first, tie, otherwise);
  return multiply(left, tied(second, tie, 1));
}

NodeId Program::place(NodeId a, std::vector<double> table) {
  ensure(table_.empty() || table_ == table, "a program has one table");
  table_ = std::move(table);
  return apply(Operation::place, {a});
}

NodeId Program::entry(NodeId place, int number) {
  return apply(Operation::entry, {place, constant(number)});
}

NodeId Program::size(NodeId a) {
  if (is_constant(a) && nodes_[a].kind == NodeKind::exact) return constant(abs(value(a)));
  return apply(Operation::size,
               {nodes_[a].operation == Operation::negate ? nodes_[a].arguments[0] : a});
}

NodeId Program::unless_moderate(NodeId a) {
  if (is_constant(a) && is_moderate(value(a))) return constant(0);
  ensure(is_constant(a) || nodes_[a].kind == NodeKind::bound, "only bounds are compared");
  return apply(Operation::unless_moderate, {a});
}

NodeId Program::magnitude(NodeId a) {
  if (is_constant(a)) return constant(abs(value(a)));
  return apply(Operation::magnitude, {a});
}

int Program::operations(const std::set<NodeId>& among) const {
  int count = 0;
  for (const NodeId id : among) {
    if (nodes_[id].kind != NodeKind::value) continue;
    switch (nodes_[id].operation) {
      case Operation::constant:
      case Operation::negate:
      case Operation::nonzero:
      case Operation::tied:
      case Operation::magnitude:
        break;
      case Operation::multiply_add:
        count += 2;
        break;
      case Operation::less_inertia:
        count += 4;
        break;
      default:
        ++count;
    }
  }
  return count;
}

std::set<NodeId> Program::needed_for(const std::vector<NodeId>& results) const {
  std::set<NodeId> needed(results.begin(), results.end());
  for (NodeId id = nodes_.size(); id-- > 0;) {
    if (!needed.contains(id)) continue;
    const Node& node = nodes_[id];
    for (std::size_t i = 0; i < arity(node.operation); ++i) needed.insert(node.arguments[i]);
  }
  return needed;
}

}  // namespace vcrit::symbolic
