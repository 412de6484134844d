// The generated header put together from its parts.
#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <map>

#include "base/joined.hpp"
#include "emit/languages/cpp/cpp_files.hpp"
#include "emit/languages/cpp/dialect.hpp"
#include "emit/languages/sections.hpp"
#include "emit/names.hpp"
#include "emit/parameters.hpp"
#include "emit/pieces.hpp"
#include "emit/words.hpp"
#include "formula/names.hpp"

VCRIT_ARITHMETIC(cpp)

namespace vcrit::symbolic {

namespace {

/// Neighbours of one type share a declaration.
std::string members(const ParameterList& parameters, const std::string& type,
                    const std::string& initial) {
  std::string out, line;
  int length = -1;
  for (const Member& member : parameters.members()) {
    const bool is_pointer = type.ends_with("*") && member.length == 0;
    const std::string name = (is_pointer ? "*" : "") + member.name + initial;
    if (member.length == length) {
      line += ", " + name;
      continue;
    }
    if (!line.empty()) out += statement(line + ";");
    length = member.length;
    line = (length == 0 ? is_pointer ? type.substr(0, type.size() - 1) : type + " "
                        : fmt::format("std::array<{}, {}> ", type, length)) +
           name;
  }
  return out + statement(line + ";");
}

/// A Varying with `entry`, "true" or "false", for every number.
std::string flags(const ParameterList& parameters, const std::string& name,
                  const std::function<std::string(const Symbol&)>& entry) {
  std::vector<std::string> all;
  for (const Member& member : parameters.members()) {
    std::vector<std::string> entries;
    for (int i = 1; i <= member.length; ++i) entries.push_back(entry({member.symbol, i}));
    all.push_back(member.length == 0 ? entry({member.symbol})
                                     : fmt::format("{{{}}}", joined(entries, ", ")));
  }
  return statement(fmt::format("constexpr Varying {}{{{}}};", name, joined(all, ", "))).substr(2);
}

/// each(f, a, b, ...): f(a.k0, b.k0, ...) for every number, without a loop, which compilers would
/// stop at.
std::string each_function(const ParameterList& parameters) {
  std::vector<std::string> calls;
  for (const Member& member : parameters.members()) {
    if (member.length == 0) calls.push_back(fmt::format("f(a.{}...);", member.name));
    for (int i = 0; i < member.length; ++i)
      calls.push_back(fmt::format("f(a.{}[{}]...);", member.name, i));
  }
  return "[[gnu::always_inline]] constexpr void each(auto f, auto&&... a) {\n" +
         statement(joined(calls, " ")) + "}\n";
}

/// Which parameters the value is computed from in more than one place.
std::string reused_flags(const ParameterList& parameters, const VelocityProgram& velocity) {
  const Program& program = velocity.program;
  std::map<Symbol, int> uses;
  for (const NodeId id : program.needed_for({velocity.above, velocity.below, velocity.factor}))
    for (std::size_t i = 0; i < arity(program[id].operation); ++i) {
      const Node& argument = program[program[id].arguments[i]];
      const bool twice = program[id].operation == Node::Operation::less_inertia && i > 0;
      if (argument.operation == Node::Operation::parameter)
        uses[argument.parameter] += twice ? 2 : 1;
    }
  return flags(parameters, "reused", [&uses](const Symbol& symbol) {
    return uses.contains(symbol) && uses.at(symbol) > 1 ? "true" : "false";
  });
}

std::string structure(const std::string& head, const std::string& members) {
  const bool is_short =
      members.find('\n') + 1 == members.size() && head.size() + members.size() < line_width;
  if (!is_short) return head + " {\n" + members + "};\n";
  return head + " {" + members.substr(1, members.size() - 2) + " };\n";
}

/// Of a type for numbers whose name no member has.
std::string each_struct(const ParameterList& parameters) {
  const auto is_taken = [&](const std::string& name) {
    return std::any_of(parameters.members().begin(), parameters.members().end(),
                       [&](const Member& member) { return member.name == name; });
  };
  std::string type = "T";
  while (is_taken(type)) type += "_";
  return structure("template <class " + type + "> struct Each", members(parameters, type, "{}"));
}

// clang takes 256 arguments of a fold expression.
constexpr std::size_t longest_fold_expression = 100;

std::string cpp_range_function(const VelocityProgram& velocity, const ParameterList& parameters,
                               const std::string& name) {
  const GuardDialect dialect(parameters);
  const StraightLine code(velocity.program, dialect);
  std::vector<std::string> tests, checked;
  const auto finish = [&] {
    if (!checked.empty())
      tests.push_back(fmt::format("within(0x1p{}, {})", velocity.exponent, joined(checked, ", ")));
    checked.clear();
  };
  for (const Guard& guard : velocity.guards) {
    if (checked.size() == longest_fold_expression) finish();
    checked.push_back(replaced(code.expression(guard.expression).text, "T(", "double("));
  }
  finish();
  if (velocity.poisson) tests.push_back(poisson_check(parameters, velocity));
  const std::string list = joined(tests, ", ");
  const std::string every = tests.size() > 1 ? "every(" + list + ")" : list;
  const std::string test = velocity.fits ? every : "false";
  return "inline bool " + name + "([[maybe_unused]] const Parameters& p) {\n" +
         statement("return " + test + ";") + "}\n";
}

/// Declarations on as many lines as they take, neighbours of one type in one statement.
std::string declarations(StraightLine& code, const std::vector<NodeId>& results,
                         const CppDialect& dialect) {
  std::string out;
  for (const auto& [kind, items] : code.declare(results))
    out += statement(fmt::format("{} {};", dialect.type(kind), joined(items, ", ")));
  return out;
}

/// The program's value and bound and, if they are asked for, the partial derivatives after it.
std::string cpp_evaluation(const VelocityProgram& velocity, const GradientProgram& gradient,
                           const ParameterList& parameters) {
  const CppDialect dialect(parameters);
  StraightLine code(gradient.program, dialect);
  const auto text = [&](NodeId id) { return code.expression(id).text; };
  std::string out =
      "template <class T> [[gnu::always_inline]] inline Result evaluate(const Parameters& p, "
      "auto&... partial) {\n";
  out += declarations(code, {velocity.above, velocity.below, velocity.factor, velocity.roundings},
                      dialect);
  const std::string value =
      fmt::format("return finished<T>(p, {}, {}, {}, {});", text(velocity.above),
                  text(velocity.below), text(velocity.factor), text(velocity.roundings));
  std::vector<NodeId> results;
  for (const auto& [symbol, partial] : gradient.partials) results.push_back(partial);
  out += "  if constexpr (sizeof...(partial) > 0) {\n" + declarations(code, results, dialect);
  std::vector<std::string> partials;
  for (const Member& member : parameters.members()) {
    std::vector<std::string> entries;
    for (int entry = member.length == 0 ? 0 : 1; entry <= member.length; ++entry) {
      const auto partial = gradient.partials.find({member.symbol, entry});
      entries.push_back(partial == gradient.partials.end()
                            ? "0.0"
                            : fmt::format("double({})", text(partial->second)));
    }
    const std::string list = joined(entries, ", ");
    partials.push_back(member.length == 0 ? list : "{" + list + "}");
  }
  return out + statement(fmt::format("((partial = {{{}}}), ...);", joined(partials, ", "))) +
         "  }\n" + statement(value) + "}\n";
}

/// v* in double for a sweep, where omega and the result are of ordinary size.
std::string polynomial_functions(const SweepProgram& sweep, const ParameterList& parameters) {
  const CppDialect dialect(parameters);
  StraightLine code(sweep.program, dialect);
  std::string out = parameters.named(cpp_sections()["polynomials"]);
  out += cpp_range_function(sweep, parameters, "has_polynomials");
  out += "inline Result evaluate_polynomials(const Parameters& p) {\n  using T = double;\n";
  out += declarations(code, {sweep.above, sweep.below, sweep.factor}, dialect);
  out += statement(fmt::format("const T above = {}, below = {};", code.expression(sweep.above).text,
                               code.expression(sweep.below).text));
  out +=
      statement(fmt::format("const T v = {}(above / below) * ({});",
                            sweep.rooted ? "std::sqrt" : "", code.expression(sweep.factor).text));
  const std::string last = replaced(parameters.named(cpp_sections()["polynomials_end"]),
                                    "THE_LEAST_OMEGA", "0x1p" + std::to_string(sweep.least_omega));
  return out + replaced(last, "THE_LEAST_SQUARE", "0x1p" + std::to_string(sweep.least_square));
}

std::string includes(const Program& program) {
  return std::string("#include <bit>\n") +
         (program.has(Node::Operation::unit) ? "#include <cstdint>\n" : "") +
         cpp_sections()["includes"];
}

// Beyond this compilers find functions too long to be copied into a loop.
constexpr int short_program = 62;

}  // namespace

std::string cpp_header(const Evaluator& evaluator, const std::string& name) {
  const Sections& sections = cpp_sections();
  const Problem& problem = evaluator.derivation.problem;
  const NamesOfScene names(problem);
  check_member_names(problem, evaluator.derivation.parameters);
  const auto& [derivation, options, fixed, parameters, velocity, gradient, sweep, operations] =
      evaluator;
  const bool is_long = operations > short_program;

  std::string out = banner(derivation, command_line(problem, name, options), fixed) +
                    table_words(velocity.program);
  out += comment(fmt::format(
      "Accuracy: one ulp wherever the bound is below 2^-52. {} operations; vectorised by "
      "-O3 -march=native -fno-math-errno.",
      operations));
  const std::string guard = guard_of(name);
  out += fmt::format("#ifndef {0}\n#define {0}\n", guard) + includes(gradient.program);
  out += fmt::format("namespace {} {{\n", name) + comment(meanings(parameters)) +
         structure("struct Parameters", members(parameters, "double", "")) + sections["structs"];
  out += std::string("namespace detail {\n") + (is_long ? sections["inline_all"] : "");
  out += sections["numbers"] + sections["operations"] + sections.rare_operations(gradient.program) +
         (sweep ? sections["steps"] : "") + cpp_range_function(velocity, parameters, "in_range") +
         "inline bool allowed(const Parameters& p) {\n" + allowed_body(parameters, velocity) +
         "}\n";
  std::string result = replaced(sections["result"], "THE_ROOT", velocity.rooted ? "sqrt" : "");
  result = replaced(result, "THE_SIMPLE_ROOT", velocity.rooted ? "std::sqrt(h)" : "h");
  out += result;
  out +=
      cpp_evaluation(velocity, gradient, parameters) + (is_long ? sections["inline_no_more"] : "");
  if (sweep) out += polynomial_functions(*sweep, parameters);
  out +=
      parameters.named(sections["sweep"]) + "}  // namespace detail\n" + sections["calls_comment"];
  out += replaced(sections["calls"], "THE_NUMBER", "detail::Twofold");
  std::string fast = replaced(sections["calls"], "THE_NUMBER", "double");
  if (sweep)
    fast =
        replaced(fast, "  detail::sweep<double>(p, omega, out);\n", sections["polynomial_sweep"]);
  out += "namespace fast {  // in plain double\n" + fast + "}  // namespace fast\n";
  // Outside of a table there is none either.
  if (velocity.program.has(Node::Operation::place))
    out = replaced(out, "NaN for 0/0 alone", "NaN for 0/0");
  return out + fmt::format("}}  // namespace {}\n#endif  // {}\n", name, guard);
}

std::string cpp_batch_header(const Evaluator& evaluator, const std::string& name) {
  const Sections& sections = cpp_sections();
  const ParameterList& parameters = evaluator.parameters;
  const std::string guard = guard_of(name + "_batch");
  return comment(
             "Generated by vcrit, do not edit. SPDX-License-Identifier: MIT-0. Batches over any "
             "parameters of " +
             name + ".hpp:") +
         parameters.named(sections["batch_comment"]) +
         fmt::format(
             "#ifndef {0}\n#define {0}\n#include <bit>\n\n#include \"{1}.hpp\"\n\nnamespace {1} "
             "{{\n",
             guard, name) +
         each_struct(parameters) + sections["each"] + "namespace detail {\n" +
         each_function(parameters) +
         flags(parameters, "all", [](const Symbol&) { return "true"; }) +
         reused_flags(parameters, evaluator.velocity) + sections["batch"] +
         "}  // namespace detail\n\n" +
         replaced(sections["batch_calls"], "THE_NUMBER", "detail::Twofold") +
         "namespace fast {  // in plain double\n" +
         replaced(sections["batch_calls"], "THE_NUMBER", "double") +
         fmt::format("}}  // namespace fast\n}}  // namespace {}\n#endif  // {}\n", name, guard);
}

}  // namespace vcrit::symbolic
