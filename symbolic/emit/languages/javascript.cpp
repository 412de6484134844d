// The JavaScript module: plain functions on objects {hi, lo}.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "emit/languages/javascript_arithmetic.hpp"
#include "emit/languages/printers.hpp"
#include "emit/pieces.hpp"
#include "emit/words.hpp"

namespace vcrit::symbolic {

namespace {

std::string javascript_operations(const Evaluator& evaluator) {
  using Operation = Node::Operation;
  std::string out = javascript::numbers;
  if (evaluator.velocity.rooted) out += javascript::root;
  // -0 comes of a negative parameter.
  out += "const within = (limit, x) => Object.is(x, 0) || (x <= limit && x * limit >= 1);\n";
  if (evaluator.has(Operation::less_inertia)) out += javascript::less_inertia;
  if (evaluator.has(Operation::unit)) out += javascript::power_unit;
  if (evaluator.has(Operation::nonzero)) out += javascript::nonzero;
  if (evaluator.has(Operation::gap)) out += javascript::ties;
  if (evaluator.has(Operation::magnitude)) out += javascript::magnitude;
  if (evaluator.has(Operation::unless_moderate)) out += javascript::unless_moderate;
  return out;
}

/// "{ mu0: 1.0, k: [2.0, 3.0] }" of the entries' texts.
std::string object(const ParameterList& parameters, const std::vector<std::string>& texts) {
  std::vector<std::string> members;
  auto next = texts.begin();
  for (const Member& member : parameters.members()) {
    const auto end = next + std::max(member.length, 1);
    const std::string list = fmt::format("{}", fmt::join(next, end, ", "));
    members.push_back(
        fmt::format("{}: {}", member.name, member.length == 0 ? list : "[" + list + "]"));
    next = end;
  }
  return fmt::format("{{ {} }}", fmt::join(members, ", "));
}

std::string javascript_evaluation(const Evaluator& evaluator, CallGrade grade,
                                  const Spelling& spelling) {
  const CallDialect dialect(evaluator.parameters, grade, spelling);
  const Body code = body(evaluator, dialect);
  const std::string kind = grade == CallGrade::accurate ? "dd" : "plain";
  std::string out = fmt::format("const {}_evaluate = (p, gradient) => {{\n", kind);
  out += statements(code.value, dialect);
  out += statement(fmt::format("const r = {}_finished({}, {}, {}, {}, in_range(p));", kind,
                               code.above, code.below, code.factor, code.roundings));
  out += "  if (!gradient) return r;\n" + statements(code.gradient, dialect);
  out += statement(fmt::format("r.partial = {};", object(evaluator.parameters, code.partials)));
  return out + "  return r;\n};\n";
}

}  // namespace

std::string javascript_text(const Evaluator& evaluator) {
  const Spelling spelling{"", "Math.abs", "Math.sqrt", false, Zeros::in_range};
  const bool rooted = evaluator.velocity.rooted;
  std::string out = comment("Parameters p: an object of numbers and arrays of numbers. " +
                            meanings(evaluator.parameters));
  for (const Member& member : evaluator.parameters.members())
    if (member.length != 0)
      out += comment(fmt::format("  {}: {} numbers", member.name, member.length));
  out += "\n" + javascript_operations(evaluator);
  out +=
      "const in_range = (p) =>\n" + statement(in_range(evaluator, spelling, " && ", "false") + ";");
  out += replaced(replaced(javascript::finished, "@SQRT", rooted ? "Math.sqrt" : ""), "@ROOT",
                  rooted ? "dd_root" : "");
  out += javascript_evaluation(evaluator, CallGrade::accurate, spelling);
  out += javascript_evaluation(evaluator, CallGrade::fast, spelling);
  out +=
      "\n" +
      comment(evaluator.parameters.named(
          "v* is infinite at resonance, 0 at antiresonance, NaN for 0/0. Batches: a value for each "
          "@omega@."));
  return out + evaluator.parameters.named(javascript::calls);
}

}  // namespace vcrit::symbolic
