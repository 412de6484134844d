// The generated library, each call of it that the header has.
#include <fmt/core.h>

#include "base/files.hpp"
#include "derivation/derivation.hpp"
#include "emit/generate.hpp"
#include "emit/parameters.hpp"
#include "speed/methods.hpp"

namespace vcrit::speed {

namespace {

/// How a call is made: `sweep` and `varying` are statements about the columns x, in the words of
/// the driver below; GRADE is the namespace of the grade.
struct Call {
  std::string name, sweep, varying;
};

const std::vector<Call>& calls() {
  static const std::vector<Call> all{
      {"batch", "GRADE::critical_velocity(first(x), omega(x, n), results);",
       "GRADE::critical_velocity({}, all_columns(x), results);"},
      {"certified batch",
       "GRADE::critical_velocity<only_omega>(first(x), all_columns(x), results, bounds);",
       "GRADE::critical_velocity({}, all_columns(x), results, bounds);"},
      {"gradient batch",
       "GRADE::critical_velocity<only_omega>(first(x), all_columns(x), results, partials(extra, "
       "n));",
       "GRADE::critical_velocity({}, all_columns(x), results, partials(extra, n));"},
      {"scalar",
       "auto p = first(x);\n"
       "  for (std::size_t i = 0; i < n; ++i) {\n"
       "    p.omega = x[1][i];\n"
       "    out[i] = GRADE::critical_velocity(p);\n"
       "  }",
       "for (std::size_t i = 0; i < n; ++i) out[i] = GRADE::critical_velocity(sets[i]);"},
      {"gradient scalar",
       "auto p = first(x);\n"
       "  for (std::size_t i = 0; i < n; ++i) {\n"
       "    p.omega = x[1][i];\n"
       "    gradients[i] = GRADE::critical_velocity_gradient(p);\n"
       "    out[i] = gradients[i].value;\n"
       "  }",
       "for (std::size_t i = 0; i < n; ++i) {\n"
       "    gradients[i] = GRADE::critical_velocity_gradient(sets[i]);\n"
       "    out[i] = gradients[i].value;\n"
       "  }"}};
  return all;
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size())
    text.replace(at, what.size(), with);
  return text;
}

std::string function_name(const std::string& grade, const Call& call, CallMode mode) {
  return replaced(grade + "_" + call.name, " ", "_") + (mode == CallMode::sweep ? "_sweep" : "");
}

/// Assignments to the members of `p`, one a column; %: the column.
std::string members(const Subject& subject, const std::string& value) {
  const symbolic::ParameterList parameters(subject.problem, symbolic::derive(subject.problem));
  std::string text;
  for (std::size_t j = 0; j < subject.columns.size(); ++j) {
    const Symbol& symbol = subject.columns[j].symbol;
    if (!parameters.contains(symbol)) continue;
    text += fmt::format("  {} = {};\n", parameters.reference(symbol),
                        replaced(value, "%", std::to_string(j)));
  }
  return text;
}

std::string driver(const Subject& subject) {
  std::string out = fmt::format(
      "#include <span>\n#include <vector>\n#include \"problem_batch.hpp\"\n"
      "using Inputs = const double* const*;\n"
      "static problem::Parameters at(Inputs x, std::size_t i) {{\n"
      "  problem::Parameters p{{}};\n{}  return p;\n}}\n"
      "static problem::Parameters first(Inputs x) {{ return at(x, 0); }}\n"
      "static std::span<const double> omega(Inputs x, std::size_t n) {{ return {{x[1], n}}; }}\n"
      "static std::vector<problem::Parameters> sets;\n"
      "static std::vector<problem::Gradient> gradients;\n"
      "constexpr problem::Varying only_omega{{.omega = true}};\n",
      members(subject, "x[%][i]"));
  out += fmt::format(
      "static problem::Columns all_columns(Inputs x) {{\n  problem::Columns p;\n{}  return p;\n"
      "}}\n"
      "static problem::PartialColumns partials(double* extra, std::size_t n) {{\n"
      "  problem::PartialColumns p;\n{}  return p;\n}}\n",
      members(subject, "x[%]"), members(subject, "extra + % * n"));
  out +=
      "extern \"C\" void prepare(Inputs x, std::size_t n, double*, double*) {\n"
      "  sets.clear();\n  for (std::size_t i = 0; i < n; ++i) sets.push_back(at(x, i));\n"
      "  gradients.resize(n);\n}\n";
  const auto add = [&](const std::string& grade, const Call& call, CallMode mode) {
    const bool sweep = mode == CallMode::sweep;
    out += fmt::format(
        "extern \"C\" void {}(Inputs x, std::size_t n, double* out, double* extra) {{\n"
        "  [[maybe_unused]] const std::span<double> results(out, n), bounds(extra, n);\n"
        "  {}\n}}\n",
        function_name(grade, call, mode),
        replaced(sweep ? call.sweep : call.varying, "GRADE",
                 grade == "fast" ? "problem::fast" : "problem"));
  };
  for (const char* grade : {"accurate", "fast"})
    for (const Call& call : calls())
      for (const CallMode mode : both_modes) add(grade, call, mode);
  return out;
}

}  // namespace

std::vector<TimedMethod> generated(const Subject& subject, const std::filesystem::path& compiler) {
  const validation::PrivateFolder folder;
  write_file(folder.path() / "problem.hpp",
             symbolic::emit_header(symbolic::derive(subject.problem), "problem"));
  write_file(folder.path() / "problem_batch.hpp",
             symbolic::emit_batch_header(symbolic::derive(subject.problem), "problem"));
  write_file(folder.path() / "driver.cpp", driver(subject));
  const auto library =
      std::make_shared<const Library>(compiler, Flags::generated(), folder.path() / "driver.cpp");
  const Function prepare = library->function("prepare");
  std::vector<TimedMethod> all;
  const auto add = [&](const std::string& grade, const Call& call, CallMode mode) {
    TimedMethod each = evaluator("vcrit " + grade + ", " + call.name, mode, library,
                                 function_name(grade, call, mode));
    each.family = MethodFamily::own;
    each.prepare = [prepare](const Samples& samples) {
      prepare(samples.columns(), samples.size(), nullptr, nullptr);
    };
    all.push_back(std::move(each));
  };
  for (const char* grade : {"accurate", "fast"})
    for (const Call& call : calls())
      for (const CallMode mode : both_modes) add(grade, call, mode);
  return all;
}

}  // namespace vcrit::speed
