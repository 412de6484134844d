// The CUDA header: functions for host and device, and kernels for batches. Its programs are written
// as in C++, on number types that a device has, too.
#include <fmt/core.h>

#include "emit/cpp_dialect.hpp"
#include "emit/languages/cuda_arithmetic.hpp"
#include "emit/languages/printers.hpp"
#include "emit/pieces.hpp"
#include "emit/words.hpp"

namespace vcrit::symbolic {

namespace {

std::string cuda_operations(const Evaluator& evaluator) {
  using Operation = Node::Operation;
  std::string out = std::string(cuda::numbers) + cuda::operations;
  if (evaluator.has(Operation::less_inertia)) out += cuda::less_inertia;
  if (evaluator.has(Operation::unit)) out += cuda::power_unit;
  if (evaluator.has(Operation::nonzero)) out += cuda::nonzero;
  if (evaluator.has(Operation::gap))
    out += replaced(cuda::ties, "@MOST", std::to_string(Program::most_edges));
  if (evaluator.has(Operation::magnitude)) out += cuda::magnitude;
  if (evaluator.has(Operation::unless_moderate)) out += cuda::unless_moderate;
  return out;
}

std::string cuda_range_function(const Evaluator& evaluator) {
  const Spelling spelling{"", "::fabs", "::sqrt", true, Zeros::out_of_range};
  return "@CALL bool in_range(const Parameters& p) {\n" +
         statement(fmt::format("return {};", in_range(evaluator, spelling, " && ", "false"))) +
         "}\n@CALL bool allowed(const Parameters& p) {\n" +
         allowed_body(evaluator.parameters, evaluator.velocity) + "}\n";
}

std::string cuda_finished(bool rooted) {
  const std::string out = replaced(cuda::finished, "@SQRT", rooted ? "::sqrt" : "");
  return replaced(out, "@ROOT", rooted ? "sqrt" : "");
}

std::string cuda_evaluation(const Evaluator& evaluator) {
  const VelocityProgram& velocity = evaluator.velocity;
  const GradientProgram& gradient = evaluator.gradient;
  const CppDialect dialect(evaluator.parameters);
  StraightLine code(gradient.program, dialect);
  const auto text = [&](NodeId id) { return code.expression(id).text; };
  std::string out = "template <class T, bool G> @CALL Result evaluate(const Parameters& p) {\n";
  out += statements(
      code.declare({velocity.above, velocity.below, velocity.factor, velocity.roundings}), dialect);
  out +=
      statement(fmt::format("Result r = finished<T>(p, {}, {}, {}, {});", text(velocity.above),
                            text(velocity.below), text(velocity.factor), text(velocity.roundings)));
  std::vector<NodeId> partials;
  for (const auto& [symbol, partial] : gradient.partials) partials.push_back(partial);
  out += "  if constexpr (G) {\n" + statements(code.declare(partials), dialect);
  for (const auto& [symbol, partial] : gradient.partials)
    out += statement(fmt::format("r.partial{} = double({});",
                                 evaluator.parameters.reference(symbol).substr(1), text(partial)));
  return out + "  }\n  return r;\n}\n";
}

std::string grade(const Evaluator& evaluator, const std::string& number) {
  return replaced(evaluator.parameters.named(cuda::calls), "@T", number);
}

}  // namespace

std::string cuda_text(const Evaluator& evaluator, const std::string& name) {
  const std::string guard = "VCRIT_GENERATED_" + name + "_CUH";
  std::string out = fmt::format("#ifndef {0}\n#define {0}\n", guard) + cuda::includes;
  out += fmt::format("namespace {} {{\n", name) + comment(meanings(evaluator.parameters)) +
         "struct Parameters {\n" + c_members(evaluator.parameters) + "};\n" + cuda::structs;
  out += "namespace detail {\n" + cuda_operations(evaluator) + cuda_range_function(evaluator) +
         cuda_finished(evaluator.velocity.rooted) + cuda_evaluation(evaluator) + cuda::result +
         "}  // namespace detail\n\n";
  out += comment(evaluator.parameters.named(
      "v* is infinite at resonance, 0 at antiresonance, NaN for 0/0. Batches: a value for each "
      "@omega@."));
  out += grade(evaluator, "detail::Twofold") + "namespace fast {  // in plain double\n" +
         grade(evaluator, "double") + "}  // namespace fast\n" +
         fmt::format("}}  // namespace {}\n", name);
  out += fmt::format("#undef @CALL\n#undef @COLD\n#endif  // {}\n", guard);
  out = replaced(out, "@CALL", "VCRIT_CALL_" + name);
  return replaced(out, "@COLD", "VCRIT_COLD_" + name);
}

}  // namespace vcrit::symbolic
