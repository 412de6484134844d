// A straight-line program over real numbers: the one description that every generated evaluator is
// written from, whatever its language and arithmetic. Nodes stand in order of computation, equal
// ones once. Constants are exact and folded exactly. No sum has a product as a term of its own: it
// becomes a multiply_add, so that a compiler that contracts to fma has nothing left to decide.
#pragma once

#include <ginac/ginac.h>

#include <array>
#include <compare>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "network/network.hpp"

namespace vcrit::symbolic {

using NodeId = std::size_t;

/// exact: a double as the user gave it. value: of the evaluator's number type. bound: an estimate,
/// where the first digits are enough.
enum class NodeKind { exact, value, bound };

struct Node {
  enum class Operation {
    parameter,
    constant,
    negate,        ///< -a
    add,           ///< a + b
    subtract,      ///< a - b
    multiply,      ///< a b
    divide,        ///< a/b
    multiply_add,  ///< a b + c
    less_inertia,  ///< a - b c^2 without loss where it nearly vanishes; all exact
    root,          ///< of a >= 0
    unit,          ///< a power of two near 1/a; a > 0
    nonzero,       ///< a; or 1 where a and b are both 0, for numbers whose range holds a zero
    gap,           ///< 2 a, and 1 more where b and c are both 0: edges of stiffness 0, one a digit
    tie,           ///< of the gaps a, what becomes of edge b; see Program::tie
    tied,          ///< a; or b c where b, a tie, is not -1
    magnitude,     ///< |a|
    size,          ///< |a| as a bound
    unless_moderate,  ///< 0 for 2^-200 < a < 2^200, else infinite; a bound
    place,  ///< of the table's row at or below a with one after it; -1 outside of the table
    entry   ///< of the table from row a on, number b; NaN for a = -1
  };
  Operation operation = Operation::constant;
  NodeKind kind = NodeKind::exact;
  std::array<NodeId, 3> arguments{};
  GiNaC::numeric constant;
  Symbol parameter;
  std::string wiring =
      {};  ///< of a tie: two nodes, small letters, for each edge; a, b the terminals
};

/// How many of `arguments` an operation has.
std::size_t arity(Node::Operation operation);

class Program {
 public:
  NodeId parameter(const Symbol& symbol);
  NodeId constant(const GiNaC::numeric& value);
  NodeId negate(NodeId a);
  NodeId add(NodeId a, NodeId b);
  NodeId subtract(NodeId a, NodeId b) { return add(a, negate(b)); }
  NodeId multiply(NodeId a, NodeId b);
  NodeId divide(NodeId a, NodeId b);
  /// a b + c
  NodeId multiply_add(NodeId a, NodeId b, NodeId c);
  NodeId less_inertia(NodeId k, NodeId m, NodeId omega);
  NodeId root(NodeId a);
  NodeId unit(NodeId a);
  NodeId nonzero(NodeId a, NodeId b);

  static constexpr std::size_t most_edges = 52;  ///< of a graph with gaps: digits of a double
  static constexpr std::size_t most_nodes = 26;  ///< letters
  /// The edges (T's components) that are 0, as a number with one binary digit each.
  NodeId gaps(const std::vector<std::pair<NodeId, NodeId>>& edges);
  /// Gaps may leave parts of a graph that nothing holds. Such a part carries no load, so that one
  /// gap that leads to it may have any stiffness: 1 for that edge, a tie. 0 for the other gaps at
  /// such a part, which have no effect, however they change. -1 for all other edges.
  NodeId tie(NodeId gaps, std::size_t edge, const std::string& wiring);
  /// a, or 0 or `otherwise` where the tie is 0 or 1.
  NodeId tied(NodeId a, NodeId tie, int otherwise);

  /// The program's one table: rows of three numbers, the first one increasing.
  NodeId place(NodeId a, std::vector<double> table);
  /// 0 to 2: of the row at this place; 3 to 5: of the next one.
  NodeId entry(NodeId place, int number);
  const std::vector<double>& table() const { return table_; }

  /// |a| as a bound.
  NodeId size(NodeId a);
  NodeId unless_moderate(NodeId a);
  /// |a|, of the same kind as a.
  NodeId magnitude(NodeId a);

  const std::vector<Node>& nodes() const { return nodes_; }
  const Node& operator[](NodeId id) const { return nodes_[id]; }
  bool is_constant(NodeId id, int value) const;
  bool has(Node::Operation operation) const;
  /// Operations of kind value; a multiply_add counts two, less_inertia four.
  int operations(const std::set<NodeId>& among) const;
  /// Every node that these depend on, themselves included.
  std::set<NodeId> needed_for(const std::vector<NodeId>& results) const;

 private:
  using Operation = Node::Operation;
  using Key = std::tuple<Operation, std::array<NodeId, 3>>;
  using Fold = std::function<GiNaC::numeric(const GiNaC::numeric&, const GiNaC::numeric&)>;
  NodeId apply(Operation operation, std::array<NodeId, 3> arguments);
  /// Two constants as one, unless that grows too long or leaves the range of doubles.
  std::optional<NodeId> fold(NodeId a, NodeId b, const Fold& operation);
  NodeId push(Node node);
  bool is_constant(NodeId id) const;
  bool is_negated(NodeId id) const;
  const GiNaC::numeric& value(NodeId id) const { return nodes_[id].constant; }

  std::vector<Node> nodes_;
  std::map<Key, NodeId> known_;
  std::map<Symbol, NodeId> parameters_;
  std::map<GiNaC::numeric, NodeId, std::less<>> constants_;
  std::vector<std::string> wirings_;
  std::vector<double> table_;
};

}  // namespace vcrit::symbolic
