// A program run with numbers, and differentiated backwards.
#pragma once

#include <cmath>
#include <functional>
#include <stdexcept>
#include <vector>

#include "program/program.hpp"

namespace vcrit::test {

using symbolic::Node;
using symbolic::NodeId;
using symbolic::NodeKind;
using symbolic::Program;
using Operation = symbolic::Node::Operation;

class Run {
 public:
  Run(const Program& program, const std::function<double(const Symbol&)>& parameter)
      : program_(program) {
    for (const Node& node : program.nodes())
      values_.push_back(node.operation == Operation::parameter ? parameter(node.parameter)
                                                               : value(node));
  }

  double operator[](NodeId id) const { return values_[id]; }

  /// Derivatives of a value by all.
  std::vector<double> derivatives(NodeId of) const {
    std::vector<double> result(values_.size());
    result[of] = 1;
    for (NodeId id = of + 1; id-- > 0;) {
      const Node& node = program_[id];
      for (std::size_t i = 0; i < arity(node.operation); ++i)
        result[node.arguments[i]] += result[id] * partial(node, i);
    }
    return result;
  }

  /// Whether an operation rounds.
  bool rounds(NodeId id) const {
    const Node& node = program_[id];
    return node.kind == NodeKind::value && arity(node.operation) > 0 &&
           node.operation != Operation::negate && node.operation != Operation::nonzero &&
           node.operation != Operation::tied;
  }

 private:
  double at(const Node& node, std::size_t i) const { return values_[node.arguments[i]]; }

  double value(const Node& node) const {
    const auto x = [&](std::size_t i) { return at(node, i); };
    switch (node.operation) {
      case Operation::constant:
        return node.constant.to_double();
      case Operation::negate:
        return -x(0);
      case Operation::add:
        return x(0) + x(1);
      case Operation::subtract:
        return x(0) - x(1);
      case Operation::multiply:
        return x(0) * x(1);
      case Operation::divide:
        return x(0) / x(1);
      case Operation::multiply_add:
        return x(0) * x(1) + x(2);
      case Operation::root:
        return std::sqrt(x(0));
      case Operation::nonzero:
      case Operation::tied:  // no element is 0
        return x(0);
      case Operation::gap:
        return 0;
      case Operation::tie:
        return -1;
      case Operation::size:
        return std::abs(x(0));
      case Operation::unless_moderate:
        return 0;
      default:
        throw std::logic_error("no operation of a graph");
    }
  }

  double partial(const Node& node, std::size_t i) const {
    switch (node.operation) {
      case Operation::negate:
        return -1;
      case Operation::add:
        return 1;
      case Operation::subtract:
        return i == 0 ? 1 : -1;
      case Operation::multiply:
        return at(node, 1 - i);
      case Operation::divide:
        return i == 0 ? 1 / at(node, 1) : -at(node, 0) / at(node, 1) / at(node, 1);
      case Operation::multiply_add:
        return i == 2 ? 1 : at(node, 1 - i);
      case Operation::nonzero:
      case Operation::tied:
        return i == 0 ? 1 : 0;
      default:
        return 0;  // of bounds, which K does not depend on
    }
  }

  const Program& program_;
  std::vector<double> values_;
};

}  // namespace vcrit::test
