// The Python module: NumPy's arithmetic on pairs of arrays.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "emit/languages/printers.hpp"
#include "emit/languages/python_arithmetic.hpp"
#include "emit/pieces.hpp"

namespace vcrit::symbolic {

namespace {

std::string python_operations(const Evaluator& evaluator) {
  using Operation = Node::Operation;
  std::string out = python::numbers;
  if (evaluator.velocity.rooted) out += python::root;
  out += python::within;
  if (evaluator.has(Operation::less_inertia)) out += python::less_inertia;
  if (evaluator.has(Operation::unit)) out += python::power_unit;
  if (evaluator.has(Operation::nonzero)) out += python::nonzero;
  if (evaluator.has(Operation::gap)) out += python::ties;
  if (evaluator.has(Operation::magnitude)) out += python::magnitude;
  if (evaluator.has(Operation::unless_moderate)) out += python::unless_moderate;
  return out;
}

/// A statement of any length has to stand on one line.
std::string python_lines(const std::vector<StraightLine::Declarations>& declarations) {
  std::string out;
  for (const auto& [kind, items] : declarations)
    for (const std::string& item : items) out += "    " + item + "\n";
  return out;
}

std::string parameters_class(const ParameterList& parameters) {
  std::string out = "@dataclass(eq=False)\nclass Parameters:\n    \"\"\"" + meanings(parameters) +
                    "\n\n    Numbers, or arrays, which broadcast.\n    \"\"\"\n\n";
  for (const Member& member : parameters.members())
    out += fmt::format(
        "    {}: Any{}\n", member.name,
        member.length == 0 ? "" : fmt::format("  # a sequence of {} of them", member.length));
  return out;
}

/// "Parameters(given(p.mu0), [given(x) for x in ...])" and its inverse from a list of all entries.
std::string conversions(const ParameterList& parameters) {
  std::vector<std::string> given, gathered;
  int next = 0;
  for (const Member& member : parameters.members()) {
    if (member.length == 0) {
      given.push_back(fmt::format("_array(p.{})", member.name));
      gathered.push_back(fmt::format("x[{}]", next++));
      continue;
    }
    given.push_back(fmt::format("_arrays(p.{}, {})", member.name, member.length));
    gathered.push_back(fmt::format("x[{}:{}]", next, next + member.length));
    next += member.length;
  }
  return fmt::format(
      "def _given(p):\n    return Parameters(\n        {},\n    )\n\n\n"
      "def _gathered(x):\n    return Parameters(\n        {},\n    )\n",
      fmt::join(given, ",\n        "), fmt::join(gathered, ",\n        "));
}

std::string python_evaluation(const Evaluator& evaluator, CallGrade grade,
                              const Spelling& spelling) {
  const CallDialect dialect(evaluator.parameters, grade, spelling);
  const Body code = body(evaluator, dialect);
  const std::string kind = grade == CallGrade::accurate ? "dd" : "plain";
  return fmt::format("\n\ndef _{}_evaluate(p, gradient):\n", kind) + python_lines(code.value) +
         fmt::format("    r = _{}_finished({}, {}, {}, {}, _in_range(p))\n", kind, code.above,
                     code.below, code.factor, code.roundings) +
         "    if not gradient:\n        return r\n" + python_lines(code.gradient) +
         fmt::format("    return r._replace(partial=[\n        {},\n    ])\n",
                     fmt::join(code.partials, ",\n        "));
}

}  // namespace

std::string python_text(const Evaluator& evaluator) {
  const Spelling spelling{"_", "np.abs", "np.sqrt", false, Zeros::in_range};
  const bool rooted = evaluator.velocity.rooted;
  std::string out = python::imports + parameters_class(evaluator.parameters) + python::tuples;
  out += conversions(evaluator.parameters) + python_operations(evaluator);
  out += "\n\ndef _in_range(p):\n    return (\n        " +
         in_range(evaluator, spelling, "\n        & ", "np.False_") + "\n    )\n";
  out += replaced(replaced(python::finished, "@SQRT", rooted ? "np.sqrt" : ""), "@ROOT",
                  rooted ? "_dd_root" : "");
  out += python_evaluation(evaluator, CallGrade::accurate, spelling);
  out += python_evaluation(evaluator, CallGrade::fast, spelling);
  return out + evaluator.parameters.named(python::calls);
}

}  // namespace vcrit::symbolic
