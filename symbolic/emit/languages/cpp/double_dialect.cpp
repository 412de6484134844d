#include "emit/languages/cpp/double_dialect.hpp"

#include <fmt/core.h>

#include "base/errors.hpp"
#include "emit/languages/cpp/dialect.hpp"

namespace vcrit::symbolic {

Operand DoubleDialect::constant(const Node& node) const {
  const double value = node.constant.to_double();
  return {literal(value), node.kind, value >= 0};
}

Operand DoubleDialect::apply(const Node& node, const std::vector<Operand>& arguments) const {
  if (const auto simple = by_operators(node, arguments)) return *simple;
  const auto call = [&](const char* function) {
    return Operand{fmt::format("{}({})", function, arguments[0].text), node.kind, true};
  };
  using Operation = Node::Operation;
  switch (node.operation) {
    case Operation::less_inertia:
      return {fmt::format("detail::exact_less_inertia({}, {}, {})", arguments[0].text,
                          arguments[1].text, arguments[2].text),
              node.kind, true};
    case Operation::root:
      return call("std::sqrt");
    case Operation::unit:
      return {fmt::format("std::ldexp(1.0, -std::ilogb({}))", arguments[0].text), node.kind, true};
    case Operation::nonzero:  // its zeros are out of range
    case Operation::tied:
      return arguments[0];
    case Operation::gap:
      return {"0.0", node.kind, true};
    case Operation::tie:
      return {"-1.0", node.kind, true};
    case Operation::place:
      return call("detail::place");
    case Operation::entry:
      return {fmt::format("detail::entry({}, {})", arguments[0].text, index(arguments[1])),
              node.kind, true};
    case Operation::magnitude:
      return call("std::fabs");
    default:
      throw Bug("no result in doubles depends on a bound");
  }
}

}  // namespace vcrit::symbolic
