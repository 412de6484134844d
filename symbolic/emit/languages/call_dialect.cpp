#include "emit/languages/call_dialect.hpp"

#include <fmt/core.h>

#include <tuple>

#include "base/errors.hpp"
#include "base/joined.hpp"
#include "emit/languages/cpp/dialect.hpp"
#include "formula/symbols.hpp"

namespace vcrit::symbolic {

namespace {

bool is_plain_double(const Operand& operand) { return operand.kind == NodeKind::exact; }

bool is_for_zeros(Node::Operation operation) {
  return operation == Node::Operation::nonzero || operation == Node::Operation::gap ||
         operation == Node::Operation::tie || operation == Node::Operation::tied;
}

}  // namespace

std::string CallDialect::function(const std::string& name) const {
  const char* grade = grade_ == CallGrade::accurate ? "dd_"
                      : grade_ == CallGrade::wide   ? "wide_"
                                                    : "plain_";
  return spelling_.prefix + grade + name;
}

Operand CallDialect::call(const std::string& name,
                          const std::vector<std::string>& arguments) const {
  return {fmt::format("{}({})", function(name), joined(arguments, ", ")), NodeKind::value, true};
}

std::string CallDialect::type(NodeKind kind) const {
  if (!spelling_.typed) return "const";
  if (kind == NodeKind::exact || grade_ == CallGrade::fast) return "const double";
  if (grade_ == CallGrade::wide) return "const " + spelling_.prefix + "wide";
  return kind == NodeKind::bound ? "const double" : "const " + spelling_.prefix + "dd";
}

Operand CallDialect::constant(const Node& node) const {
  const double high = node.constant.to_double();
  if (node.kind == NodeKind::exact || grade_ == CallGrade::fast)
    return {literal(high), node.kind, high >= 0};
  const double low = (node.constant - exact_binary(high)).to_double();
  return call("number", {literal(high), literal(low)});
}

std::string CallDialect::number(const Operand& operand) const {
  if (grade_ == CallGrade::fast || !is_plain_double(operand)) return operand.text;
  return call("of", {operand.text}).text;
}

std::string CallDialect::bound(const Operand& operand) const {
  return grade_ == CallGrade::wide ? number(operand) : rounded(operand);
}

std::string CallDialect::rounded(const Operand& operand) const {
  if (grade_ == CallGrade::fast || is_plain_double(operand)) return operand.text;
  if (grade_ == CallGrade::wide) return call("rounded", {operand.text}).text;
  return operand.kind == NodeKind::bound ? operand.text : operand.text + ".hi";
}

// Without zeros a gap and a tie are numbers, and of the rest the first argument is left.
bool CallDialect::reads(const Node& node, std::size_t argument) const {
  if (!is_for_zeros(node.operation) || knows_zeros()) return true;
  return argument == 0 && node.operation != Operation::gap && node.operation != Operation::tie;
}

// What is there for zeros alone: where they are out of range, only wide numbers know it.
Operand CallDialect::with_zeros(const Node& node, const Arguments& arguments) const {
  const auto [a, b, c] = std::tie(arguments[0], arguments[1], arguments.back());
  const bool known = knows_zeros();
  const bool in_grade = node.kind == NodeKind::value || grade_ == CallGrade::wide;
  const bool plain = node.kind == NodeKind::exact || !in_grade;
  const auto operand = [&](const Operand& x) { return plain ? rounded(x) : number(x); };
  const auto result = [&](const std::string& text) { return Operand{text, node.kind, true}; };
  const auto unchanged = [&] { return Operand{operand(a), node.kind, a.is_simple}; };
  const auto call = [&](const std::string& name, const std::string& last) {
    const std::string whole = plain ? spelling_.prefix + "plain_" + name : function(name);
    return result(fmt::format("{}({}, {})", whole, operand(a), last));
  };
  switch (node.operation) {
    case Operation::nonzero:
      return known ? call("nonzero", operand(b)) : unchanged();
    case Operation::tied:
      return known ? call("tied", b.text + ", " + c.text) : unchanged();
    case Operation::gap:
      if (!known) return result("0.0");
      return result(fmt::format("{}({}, {}, {})", function("gap"), a.text, number(b), number(c)));
    default:
      if (!known) return result("-1.0");
      return result(
          fmt::format("{}tie(\"{}\", {}, {})", spelling_.prefix, node.wiring, a.text, index(b)));
  }
}

// Of doubles in every grade.
Operand CallDialect::of_table(const Node& node, const Arguments& arguments) const {
  const std::string& a = arguments[0].text;
  if (node.operation == Operation::place)
    return {fmt::format("{}place({})", spelling_.prefix, a), node.kind, true};
  return {fmt::format("{}entry({}, {})", spelling_.prefix, a, index(arguments[1])), node.kind,
          true};
}

Operand CallDialect::apply(const Node& node, const std::vector<Operand>& arguments) const {
  if (node.operation == Operation::place || node.operation == Operation::entry)
    return of_table(node, arguments);
  if (is_for_zeros(node.operation)) return with_zeros(node, arguments);
  const bool bound = node.kind == NodeKind::bound && grade_ != CallGrade::wide;
  const bool exact = node.kind == NodeKind::exact;
  Operand result = grade_ == CallGrade::fast || bound || exact ? in_doubles(node, arguments)
                                                               : in_calls(node, arguments);
  result.kind = node.kind;
  return result;
}

Operand CallDialect::in_doubles(const Node& node, const Arguments& arguments) const {
  Arguments doubles;
  for (const Operand& argument : arguments)
    doubles.push_back({rounded(argument), NodeKind::exact, argument.is_simple});
  if (const auto simple = by_operators(node, doubles)) return *simple;
  const auto calling = [&](const std::string& name) {
    return Operand{fmt::format("{}({})", name, rounded(arguments[0])), node.kind, true};
  };
  switch (node.operation) {
    case Operation::less_inertia:
      return call("less_inertia", {arguments[0].text, arguments[1].text, arguments[2].text});
    case Operation::root:
      return calling(spelling_.sqrt);
    case Operation::unit:
      if (grade_ == CallGrade::wide) return call("unit", {number(arguments[0])});
      return calling(spelling_.prefix + "unit");
    case Operation::magnitude:
    case Operation::size:
      return calling(spelling_.abs);
    case Operation::unless_moderate:
      return calling(spelling_.prefix + "unless_moderate");
    default:
      throw Bug("a node without arguments is no operation");
  }
}

Operand CallDialect::negated(const Operand& a) const {
  if (is_plain_double(a)) return {"-" + in_brackets(a), NodeKind::exact, false};
  return call("negated", {a.text});
}

Operand CallDialect::sum(const Operand& a, const Operand& b) const {
  if (grade_ == CallGrade::wide) return call("add", {number(a), number(b)});
  if (is_plain_double(a) && is_plain_double(b)) return call("sum", {a.text, b.text});
  if (is_plain_double(b)) return call("add_d", {a.text, b.text});
  if (is_plain_double(a)) return call("add_d", {b.text, a.text});
  return call("add", {a.text, b.text});
}

Operand CallDialect::product(const Operand& a, const Operand& b) const {
  if (grade_ == CallGrade::wide) return call("mul", {number(a), number(b)});
  if (is_plain_double(a) && is_plain_double(b)) return call("product", {a.text, b.text});
  if (is_plain_double(b)) return call("mul_d", {a.text, b.text});
  if (is_plain_double(a)) return call("mul_d", {b.text, a.text});
  return call("mul", {a.text, b.text});
}

Operand CallDialect::in_calls(const Node& node, const Arguments& arguments) const {
  const auto a = [&] { return arguments[0]; };
  const auto b = [&] { return arguments[1]; };
  switch (node.operation) {
    case Operation::negate:
      return negated(a());
    case Operation::add:
      return sum(a(), b());
    case Operation::subtract:
      return sum(a(), negated(b()));
    case Operation::multiply:
      return product(a(), b());
    case Operation::divide:
      return call("div", {number(a()), number(b())});
    case Operation::multiply_add:
      return sum(product(a(), b()), arguments[2]);
    case Operation::less_inertia:
      return call("less_inertia", {a().text, b().text, arguments[2].text});
    case Operation::root:
      return call("root", {number(a())});
    case Operation::magnitude:
    case Operation::size:
      return call("magnitude", {number(a())});
    case Operation::unless_moderate:
      return call("unless_moderate", {number(a())});
    default:
      break;
  }
  throw Bug("not an operation on values");
}

}  // namespace vcrit::symbolic
