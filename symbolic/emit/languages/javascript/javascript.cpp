// The JavaScript module: plain functions on objects {hi, lo}.
#include <fmt/core.h>

#include <algorithm>

#include "base/joined.hpp"
#include "emit/languages/language.hpp"
#include "emit/languages/sections.hpp"
#include "emit/pieces.hpp"
#include "emit/words.hpp"

VCRIT_ARITHMETIC(javascript)

namespace vcrit::symbolic {

namespace {

std::string javascript_operations(const Evaluator& evaluator) {
  const Sections& sections = javascript_sections();
  return sections["numbers"] + (evaluator.velocity.rooted ? sections["root"] : "") +
         sections["within"] + sections.rare_operations(evaluator.gradient.program);
}

/// "{ mu0: 1.0, k: [2.0, 3.0] }" of the entries' texts.
std::string object(const ParameterList& parameters, const std::vector<std::string>& texts) {
  std::vector<std::string> members;
  auto next = texts.begin();
  for (const Member& member : parameters.members()) {
    const auto end = next + std::max(member.length, 1);
    const std::string list = joined(std::vector<std::string>(next, end), ", ");
    members.push_back(
        fmt::format("{}: {}", member.name, member.length == 0 ? list : "[" + list + "]"));
    next = end;
  }
  return fmt::format("{{ {} }}", joined(members, ", "));
}

std::string javascript_evaluation(const Evaluator& evaluator, CallGrade grade,
                                  const Spelling& spelling) {
  const CallDialect dialect(evaluator.parameters, grade, spelling);
  const FunctionBody code = body(evaluator, dialect);
  const std::string kind = grade == CallGrade::accurate ? "dd" : "plain";
  std::string out = fmt::format("const {}_evaluate = (p, gradient) => {{\n", kind);
  out += statements(code.value, dialect);
  out += statement(fmt::format("const r = {}_finished({}, {}, {}, {}, in_range(p));", kind,
                               code.above, code.below, code.factor, code.roundings));
  out += "  if (!gradient) return r;\n" + statements(code.gradient, dialect);
  out += statement(fmt::format("r.partial = {};", object(evaluator.parameters, code.partials)));
  return out + "  return r;\n};\n";
}

std::string javascript_text(const Evaluator& evaluator, const std::string&) {
  const Sections& sections = javascript_sections();
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
  out += replaced(replaced(sections["finished"], "THE_SQUARE_ROOT", rooted ? "Math.sqrt" : ""),
                  "THE_ROOT", rooted ? "dd_root" : "");
  out += javascript_evaluation(evaluator, CallGrade::accurate, spelling);
  out += javascript_evaluation(evaluator, CallGrade::fast, spelling);
  out +=
      "\n" +
      comment(evaluator.parameters.named(
          "v* is infinite at resonance, 0 at antiresonance, NaN for 0/0. Batches: a value for each "
          "THE_OMEGA."));
  return out + evaluator.parameters.named(sections["calls"]);
}

}  // namespace

extern const Language javascript{
    .name = "javascript",
    .extension = ".mjs",
    .zeros = Zeros::in_range,
    .reserved =
        "arguments debugger eval extends implements instanceof interface "
        "null package super undefined",
    .text = javascript_text};

}  // namespace vcrit::symbolic
