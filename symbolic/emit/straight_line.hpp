// A Program as statements of a programming language.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "program/program.hpp"

namespace vcrit::symbolic {

/// An operand, or the text of a whole expression.
struct Operand {
  std::string text;
  NodeKind kind = NodeKind::exact;
  bool is_simple = true;  ///< a name, literal or call: needs no brackets
};

/// How one language writes what a node does.
class CodeDialect {
 public:
  virtual ~CodeDialect() = default;
  virtual std::string parameter(const Symbol& symbol) const = 0;
  virtual Operand constant(const Node& node) const = 0;
  virtual Operand apply(const Node& node, const std::vector<Operand>& arguments) const = 0;
  /// Whether what apply() writes contains this argument.
  virtual bool reads(const Node& /*node*/, std::size_t /*argument*/) const { return true; }
  /// "const T name = " without the value; several of one kind may share a statement.
  virtual std::string type(NodeKind kind) const = 0;
};

/// A double as all these languages write it.
std::string literal(double value);

/// "a", or "(a + b)".
std::string in_brackets(const Operand& operand);

/// "3" of the constant 3, which stands for a place in a list.
std::string index(const Operand& constant);

/// What the operators of all these languages do with doubles; nothing for other operations.
std::optional<Operand> by_operators(const Node& node, const std::vector<Operand>& arguments);

class StraightLine {
 public:
  StraightLine(const Program& program, const CodeDialect& dialect)
      : program_(program), dialect_(dialect) {}

  /// Declarations "a1 = ..., a2 = ..." by kind, in order, of what the results need; a node that is
  /// used once and short stands where it is used.
  struct Declarations {
    NodeKind kind;
    std::vector<std::string> items;  ///< "name = expression"
  };
  std::vector<Declarations> declare(const std::vector<NodeId>& results);
  /// A result: its name, or the expression of what declare() has named.
  Operand expression(NodeId id) const;

 private:
  Operand in_bound(NodeId id) const;
  std::map<NodeId, int> uses_of(const std::set<NodeId>& needed) const;
  std::set<NodeId> written_for(const std::vector<NodeId>& results) const;

  const Program& program_;
  const CodeDialect& dialect_;
  std::map<NodeId, Operand> known_;
  int count_ = 0;
};

}  // namespace vcrit::symbolic
