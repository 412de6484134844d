// The CUDA header: functions for host and device, and kernels for batches. Its programs are written
// as in C++, on number types that a device has, too.
#include <fmt/core.h>

#include "emit/languages/cpp/dialect.hpp"
#include "emit/languages/language.hpp"
#include "emit/languages/sections.hpp"
#include "emit/pieces.hpp"
#include "emit/words.hpp"

VCRIT_ARITHMETIC(cuda)

namespace vcrit::symbolic {

namespace {

// What CUDA's headers declare for everyone beside the C library.
const char* const cuda_names = R"(
threadIdx blockIdx blockDim gridDim warpSize dim3 min max norm norm3d norm4d normcdf
normcdfinv rnorm rnorm3d rnorm4d rhypot rsqrt rcbrt sinpi cospi sincospi erfinv erfcinv
erfcx clock clock64 abort assert printf cuda nvcuda cooperative_groups thrust cub
)";

std::string cuda_range_function(const Evaluator& evaluator) {
  const Spelling spelling{"", "::fabs", "::sqrt", true, Zeros::out_of_range};
  return "THE_CALL bool in_range(const Parameters& p) {\n" +
         statement(
             fmt::format("return {};", in_range(evaluator, spelling, " && ", "((void)p, false)"))) +
         "}\nTHE_CALL bool allowed(const Parameters& p) {\n" +
         allowed_body(evaluator.parameters, evaluator.velocity) + "}\n";
}

std::string cuda_finished(bool rooted) {
  const std::string out =
      replaced(cuda_sections()["finished"], "THE_SQUARE_ROOT", rooted ? "::sqrt" : "");
  return replaced(out, "THE_ROOT", rooted ? "sqrt" : "");
}

std::string cuda_evaluation(const Evaluator& evaluator) {
  const VelocityProgram& velocity = evaluator.velocity;
  const GradientProgram& gradient = evaluator.gradient;
  const CppDialect dialect(evaluator.parameters);
  StraightLine code(gradient.program, dialect);
  const auto text = [&](NodeId id) { return code.expression(id).text; };
  std::string out = "template <class T, bool G> THE_CALL Result evaluate(const Parameters& p) {\n";
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
  return replaced(evaluator.parameters.named(cuda_sections()["calls"]), "THE_NUMBER", number);
}

std::string cuda_text(const Evaluator& evaluator, const std::string& name) {
  const Sections& sections = cuda_sections();
  const std::string guard = "VCRIT_GENERATED_" + name + "_CUH";
  std::string out = fmt::format("#ifndef {0}\n#define {0}\n", guard) + sections["includes"];
  out += fmt::format("namespace {} {{\n", name) + comment(meanings(evaluator.parameters)) +
         "struct Parameters {\n" + c_members(evaluator.parameters) + "};\n" + sections["structs"];
  out += "namespace detail {\n" + sections["numbers"] + sections["operations"] +
         sections.rare_operations(evaluator.gradient.program) + cuda_range_function(evaluator) +
         cuda_finished(evaluator.velocity.rooted) + cuda_evaluation(evaluator) +
         sections["result"] + "}  // namespace detail\n\n";
  out += comment(evaluator.parameters.named(
      "v* is infinite at resonance, 0 at antiresonance, NaN for 0/0. Batches: a value for each "
      "THE_OMEGA."));
  out += grade(evaluator, "detail::Twofold") + "namespace fast {  // in plain double\n" +
         grade(evaluator, "double") + "}  // namespace fast\n" +
         fmt::format("}}  // namespace {}\n", name);
  out += fmt::format("#undef THE_CALL\n#undef THE_COLD\n#endif  // {}\n", guard);
  out = replaced(out, "THE_CALL", "VCRIT_CALL_" + name);
  return replaced(out, "THE_COLD", "VCRIT_COLD_" + name);
}

}  // namespace

extern const Language cuda{
    .name = "cuda", .extension = ".cuh", .taken = cuda_names, .text = cuda_text};

}  // namespace vcrit::symbolic
