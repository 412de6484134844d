// Programs in C++ on plain doubles.
#pragma once

#include "emit/parameters.hpp"
#include "emit/straight_line.hpp"

namespace vcrit::symbolic {

class DoubleDialect : public CodeDialect {
 public:
  explicit DoubleDialect(const ParameterList& parameters) : parameters_(parameters) {}
  std::string parameter(const Symbol& symbol) const override {
    return parameters_.reference(symbol);
  }
  Operand constant(const Node& node) const override;
  /// less_inertia is detail::exact_less_inertia(k, m, w).
  Operand apply(const Node& node, const std::vector<Operand>& arguments) const override;
  std::string type(NodeKind) const override { return "const double"; }

 private:
  const ParameterList& parameters_;
};

}  // namespace vcrit::symbolic
