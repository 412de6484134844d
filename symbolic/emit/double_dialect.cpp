#include "emit/double_dialect.hpp"

#include <fmt/format.h>

#include "base/errors.hpp"
#include "emit/cpp_dialect.hpp"

namespace vcrit::symbolic {

Operand DoubleDialect::constant(const Node& node) const {
  const double value = node.constant.to_double();
  return {literal(value), node.kind, value >= 0};
}

Operand DoubleDialect::apply(const Node& node, const std::vector<Operand>& arguments) const {
  const auto bracketed = [&](std::size_t i) { return in_brackets(arguments[i]); };
  const auto infix = [&](const char* sign) {
    return Operand{fmt::format("{} {} {}", bracketed(0), sign, bracketed(1)), node.kind, false};
  };
  const auto call = [&](const char* function) {
    return Operand{fmt::format("{}({})", function, arguments[0].text), node.kind, true};
  };
  using Operation = Node::Operation;
  switch (node.operation) {
    case Operation::negate:
      return {"-" + bracketed(0), node.kind, false};
    case Operation::add:
      return infix("+");
    case Operation::subtract:
      return infix("-");
    case Operation::multiply:
      return infix("*");
    case Operation::divide:
      return infix("/");
    case Operation::multiply_add:
      return {fmt::format("{} * {} + {}", bracketed(0), bracketed(1), bracketed(2)), node.kind,
              false};
    case Operation::less_inertia:
      return {fmt::format("detail::exact_less_inertia({}, {}, {})", arguments[0].text,
                          arguments[1].text, arguments[2].text),
              node.kind, true};
    case Operation::root:
      return call("std::sqrt");
    case Operation::unit:
      return {fmt::format("std::ldexp(1.0, -std::ilogb({}))", arguments[0].text), node.kind, true};
    case Operation::nonzero:  // its zeros are out of range
      return arguments[0];
    case Operation::magnitude:
      return call("std::fabs");
    default:
      throw Bug("no result in doubles depends on a bound");
  }
}

}  // namespace vcrit::symbolic
