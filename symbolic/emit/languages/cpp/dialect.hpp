// Programs in C++, on numbers of a type T: double, Twofold or Wide.
#pragma once

#include "emit/parameters.hpp"
#include "emit/straight_line.hpp"

namespace vcrit::symbolic {

class CppDialect : public CodeDialect {
 public:
  explicit CppDialect(const ParameterList& parameters) : parameters_(parameters) {}
  std::string parameter(const Symbol& symbol) const override {
    return parameters_.reference(symbol);
  }
  Operand constant(const Node& node) const override;
  Operand apply(const Node& node, const std::vector<Operand>& arguments) const override;
  std::string type(NodeKind kind) const override {
    return kind == NodeKind::bound   ? "const auto"
           : kind == NodeKind::exact ? "const double"
                                     : "const T";
  }

 private:
  const ParameterList& parameters_;
};

/// In doubles, of parameters that have to be positive.
class GuardDialect : public CppDialect {
 public:
  using CppDialect::CppDialect;
  Operand apply(const Node& node, const std::vector<Operand>& arguments) const override {
    return node.operation == Node::Operation::size ? arguments[0]
                                                   : CppDialect::apply(node, arguments);
  }
};

}  // namespace vcrit::symbolic
