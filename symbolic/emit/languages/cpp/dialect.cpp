#include "emit/languages/cpp/dialect.hpp"

#include <fmt/core.h>

#include "base/errors.hpp"
#include "formula/symbols.hpp"

namespace vcrit::symbolic {

Operand CppDialect::constant(const Node& node) const {
  const double high = node.constant.to_double();
  if (node.kind == NodeKind::exact) return {literal(high), NodeKind::exact, high >= 0};
  const double low = (node.constant - exact_binary(high)).to_double();
  return {fmt::format("T(Twofold({}, {}))", literal(high), literal(low)), NodeKind::value, true};
}

Operand CppDialect::apply(const Node& node, const std::vector<Operand>& arguments) const {
  const auto a = [&] { return arguments[0]; };
  const auto b = [&] { return arguments[1]; };
  const auto call = [&](const char* function) {
    std::string text = std::string(function) + "(" + arguments[0].text;
    for (std::size_t i = 1; i < arguments.size(); ++i) text += ", " + arguments[i].text;
    return Operand{text + ")", node.kind, true};
  };
  const auto infix = [&](const char* sign, const Operand& left, const Operand& right) {
    return Operand{fmt::format("{} {} {}", left.text, sign, right.text), node.kind, false};
  };
  const auto bracketed = [](Operand x) {
    x.text = in_brackets(x);
    x.is_simple = true;
    return x;
  };
  // Where both are doubles the operator would round as doubles do.
  const bool given = node.kind == NodeKind::value && a().kind == NodeKind::exact &&
                     (arguments.size() < 2 || b().kind == NodeKind::exact);
  using Operation = Node::Operation;
  switch (node.operation) {
    case Operation::negate:
      return {"-" + in_brackets(a()), node.kind, false};
    case Operation::add:
      if (given) return {fmt::format("T({}) + T({})", a().text, b().text), node.kind, false};
      return infix("+", bracketed(a()), bracketed(b()));
    case Operation::subtract:
      if (given) return {fmt::format("T({}) + -T({})", a().text, b().text), node.kind, false};
      return {fmt::format("{} + -{}", in_brackets(a()), in_brackets(b())), node.kind, false};
    case Operation::multiply:
      return given ? call("times<T>") : infix("*", bracketed(a()), bracketed(b()));
    case Operation::divide:
      if (given) return {fmt::format("T({}) / {}", a().text, in_brackets(b())), node.kind, false};
      return infix("/", bracketed(a()), bracketed(b()));
    case Operation::multiply_add:
      return call("mad<T>");
    case Operation::less_inertia:
      return call("less_inertia<T>");
    case Operation::root:
      return call("sqrt");
    case Operation::unit:
      return call("unit");
    case Operation::nonzero:
      return call(node.kind == NodeKind::bound ? "nonzero" : "nonzero<T>");
    case Operation::gap:
      return call("gap<T>");
    case Operation::tie:
      return {fmt::format("tie<T>(\"{}\", {}, {})", node.wiring, a().text, index(b())), node.kind,
              true};
    case Operation::tied:
      return call("tied<T>");
    case Operation::place:
      return call("place");
    case Operation::entry:
      return {fmt::format("entry({}, {})", a().text, index(b())), node.kind, true};
    case Operation::magnitude:
      return given ? Operand{fmt::format("T(std::fabs({}))", a().text), node.kind, true}
                   : call("magnitude");
    case Operation::size:  // of a parameter, too, in the range of T
      if (a().kind == NodeKind::exact)
        return {fmt::format("size(T({}))", a().text), node.kind, true};
      return call("size");
    case Operation::unless_moderate:
      return call("unless_moderate");
    case Operation::parameter:
    case Operation::constant:
      break;
  }
  throw Bug("a node without arguments is no operation");
}

}  // namespace vcrit::symbolic
