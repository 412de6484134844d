// Programs in languages without operators of one's own: numbers with twice the digits (dd) and wide
// ones by calls, chosen by the operands' kinds; plain doubles and bounds by operators.
#pragma once

#include "emit/parameters.hpp"
#include "emit/straight_line.hpp"
#include "program/range.hpp"

namespace vcrit::symbolic {

/// accurate: twice the digits. fast: doubles. wide: twice the digits, exponents without end.
enum class CallGrade { accurate, fast, wide };

struct Spelling {
  std::string prefix;     ///< of the functions that the generated file brings along
  std::string abs, sqrt;  ///< of doubles
  bool typed = false;     ///< declarations name a type: double, PREFIXdd, PREFIXwide
  Zeros zeros = Zeros::out_of_range;
};

class CallDialect : public CodeDialect {
 public:
  CallDialect(const ParameterList& parameters, CallGrade grade, Spelling spelling)
      : parameters_(parameters), grade_(grade), spelling_(std::move(spelling)) {}

  std::string parameter(const Symbol& symbol) const override {
    return parameters_.reference(symbol);
  }
  Operand constant(const Node& node) const override;
  Operand apply(const Node& node, const std::vector<Operand>& arguments) const override;
  bool reads(const Node& node, std::size_t argument) const override;
  std::string type(NodeKind kind) const override;

  /// An operand as a number or a bound of the grade, or rounded to a double.
  std::string number(const Operand& operand) const;
  std::string bound(const Operand& operand) const;
  std::string rounded(const Operand& operand) const;

 private:
  using Operation = Node::Operation;
  using Arguments = std::vector<Operand>;
  bool knows_zeros() const {
    return grade_ == CallGrade::wide || spelling_.zeros == Zeros::in_range;
  }
  Operand with_zeros(const Node& node, const Arguments& arguments) const;
  Operand of_table(const Node& node, const Arguments& arguments) const;
  Operand in_doubles(const Node& node, const Arguments& arguments) const;
  Operand in_calls(const Node& node, const Arguments& arguments) const;
  Operand negated(const Operand& a) const;
  Operand sum(const Operand& a, const Operand& b) const;
  Operand product(const Operand& a, const Operand& b) const;
  /// A call of a function of the grade.
  Operand call(const std::string& name, const std::vector<std::string>& arguments) const;
  std::string function(const std::string& name) const;

  const ParameterList& parameters_;
  CallGrade grade_;
  Spelling spelling_;
};

/// In doubles, of parameters that have to be positive.
class GuardCalls : public CallDialect {
 public:
  GuardCalls(const ParameterList& parameters, const Spelling& spelling)
      : CallDialect(parameters, CallGrade::fast, spelling) {}
  Operand apply(const Node& node, const std::vector<Operand>& arguments) const override {
    return node.operation == Node::Operation::size ? arguments[0]
                                                   : CallDialect::apply(node, arguments);
  }
};

}  // namespace vcrit::symbolic
