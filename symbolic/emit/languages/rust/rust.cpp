// The Rust module: functions on copied structures, of the standard library alone.
#include <fmt/core.h>

#include <algorithm>

#include "base/joined.hpp"
#include "emit/languages/language.hpp"
#include "emit/languages/sections.hpp"
#include "emit/pieces.hpp"
#include "emit/words.hpp"

VCRIT_ARITHMETIC(rust)

namespace vcrit::symbolic {

namespace {

// Those that are reserved in C++ as well are refused as names of a scene.
constexpr std::string_view rust_keywords =
    "abstract as become box crate dyn final fn gen impl loop macro match mod move mut override "
    "priv pub ref self Self super trait type unsafe unsized use where";
// Of these there is no raw identifier.
constexpr std::string_view rust_paths = "crate self Self super";

/// No name of a scene has two underscores in a row.
std::string rust_spelled(const std::string& name) {
  if (is_among(rust_paths, name)) return name + "__";
  return is_among(rust_keywords, name) ? "r#" + name : name;
}

std::string rust_statement(const std::string& text, int depth = 1) {
  const std::string indent(4 * static_cast<std::size_t>(depth) - 2, ' ');
  std::string out = indent + statement(text);
  out.pop_back();
  return replaced(out, "\n", "\n" + indent) + "\n";
}

std::string rust_lines(const std::vector<StraightLine::Declarations>& declarations, int depth) {
  std::string out;
  for (const auto& [kind, items] : declarations)
    for (const std::string& item : items) out += rust_statement("let " + item + ";", depth);
  return out;
}

std::string rust_parameters(const ParameterList& parameters) {
  std::string out =
      "#[derive(Clone, Copy, Debug, PartialEq)]\n#[repr(C)]\npub struct Parameters {\n";
  for (const Member& member : parameters.members())
    out += fmt::format("    pub {}: {},\n", member.name,
                       member.length == 0 ? "f64" : fmt::format("[f64; {}]", member.length));
  return out + "}\n";
}

/// Whether all parameters are finite and of a sign that a scene may have.
std::string rust_allowed(const Evaluator& evaluator) {
  const VelocityProgram& velocity = evaluator.velocity;
  std::vector<std::string> all = evaluator.parameters.references(velocity.program);
  std::string rest;
  if (velocity.poisson) {
    std::erase(all, evaluator.parameters.reference(*velocity.poisson));
    rest = " && " + poisson_check(evaluator.parameters, velocity);
  }
  return rust_statement(fmt::format("let all = [{}];", joined(all, ", "))) +
         rust_statement("all.iter().all(|x| (0.0..=f64::MAX).contains(x))" + rest);
}

std::string rust_evaluation(const Evaluator& evaluator, CallGrade grade, const Spelling& spelling) {
  const CallDialect dialect(evaluator.parameters, grade, spelling);
  const FunctionBody code = body(evaluator, dialect);
  const std::string kind = grade == CallGrade::accurate ? "dd"
                           : grade == CallGrade::fast   ? "plain"
                                                        : "wide";
  std::string out = fmt::format(
      "fn {}_evaluate(p: &Parameters, partial: Option<&mut Parameters>) -> Evaluated {{\n", kind);
  out += rust_lines(code.value, 1) + rust_statement("if let Some(d) = partial {") +
         rust_lines(code.gradient, 2);
  const std::vector<std::string> names = entries(evaluator.parameters);
  for (std::size_t i = 0; i < names.size(); ++i)
    out += rust_statement(fmt::format("d.{} = {};", names[i], code.partials[i]), 2);
  return out + rust_statement("}") +
         rust_statement(fmt::format("{}_finished({}, {}, {}, {}, {}(p))", kind, code.above,
                                    code.below, code.factor, code.roundings,
                                    grade == CallGrade::wide ? "allowed" : "in_range")) +
         "}\n";
}

std::string rust_calls(const Evaluator& evaluator, const std::string& grade,
                       const std::string& prefix) {
  const std::string calls = evaluator.parameters.named(rust_sections()["calls"]);
  return replaced(replaced(calls, "THE_GRADE", grade), "THE_FAST_", prefix);
}

std::string rust_text(const Evaluator& evaluator, const std::string&) {
  const Sections& sections = rust_sections();
  const Spelling spelling{"", "f64::abs", "f64::sqrt", false, Zeros::out_of_range};
  const ParameterList& parameters = evaluator.parameters;
  const bool rooted = evaluator.velocity.rooted;
  std::string out = sections["begin"] + comment(meanings(parameters)) + rust_parameters(parameters);
  out += sections["structs"] + sections["numbers"] + sections["wide"] +
         sections.rare_operations(evaluator.gradient.program);
  out += "fn in_range(p: &Parameters) -> bool {\n" +
         rust_statement(in_range(evaluator, spelling, " && ", "false")) +
         "}\nfn allowed(p: &Parameters) -> bool {\n" + rust_allowed(evaluator) + "}\n";
  std::string finished =
      replaced(sections["finished"], "THE_SQUARE_ROOT", rooted ? "f64::sqrt" : "");
  finished = replaced(finished, "THE_DD_ROOT", rooted ? "dd_root" : "");
  out += replaced(finished, "THE_WIDE_ROOT", rooted ? "wide_root" : "");
  for (const CallGrade grade : {CallGrade::accurate, CallGrade::fast, CallGrade::wide})
    out += rust_evaluation(evaluator, grade, spelling);
  out +=
      "\n" + comment(parameters.named(
                 "v* is infinite at resonance, 0 at antiresonance, NaN for 0/0. Batches: a value "
                 "for each THE_OMEGA."));
  return out + rust_calls(evaluator, "dd", "") + comment("In plain double.") +
         rust_calls(evaluator, "plain", "fast_") + sections["end"];
}

}  // namespace

extern const Language rust{.name = "rust",
                           .extension = ".rs",
                           .taken = rust_keywords,
                           .spelled = rust_spelled,
                           .text = rust_text};

}  // namespace vcrit::symbolic
