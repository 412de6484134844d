#include "accuracy/driver_source.hpp"

#include <fmt/core.h>

#include "accuracy/pasted.hpp"
#include "derivation/derivation.hpp"
#include "emit/parameters.hpp"

namespace vcrit::validation::accuracy {

namespace {

const char* const includes = R"(#include <algorithm>
#include <chrono>
#include <cmath>
#include <complex>
#include <cstdio>
#include <span>
#include <string_view>
#include <vector>
)";

// One pass over thousands of sets takes longer than the clock's grain; the first one warms up.
const char* const measuring = R"(
static std::vector<Parameters> sets;
static std::vector<double> omegas;

template <class Run> static double time_of(const Run& run) {
  using Clock = std::chrono::steady_clock;
  std::vector<double> times;
  for (int i = 0; i < 9; ++i) {
    const Clock::time_point begin = Clock::now();
    run();
    times.push_back(std::chrono::duration<double, std::nano>(Clock::now() - begin).count());
  }
  std::nth_element(times.begin(), times.begin() + 4, times.end());
  return times[4] / static_cast<double>(sets.size());
}
template <class Values, class Timed>
static void answer(std::FILE* file, std::vector<double>& out, const Values& values, const Timed& timed) {
  std::fill(out.begin(), out.end(), NAN);
  values();
  const std::vector<double> found = out;
  std::fprintf(file, "%a\n", time_of(timed));
  for (const double value : found) std::fprintf(file, "%a\n", value);
}
)";

const char* const main_begins = R"(
int main(int count, char** words) {
  std::FILE* const in = std::fopen(words[1], "r");
  std::FILE* const file = std::fopen(words[2], "w");
  if (in == nullptr || file == nullptr) return 1;
  for (Parameters p{}; read(in, p);) sets.push_back(p);
  for (const Parameters& p : sets) omegas.push_back(p.omega);
  std::vector<double> out(sets.size());
)";

std::string loop(const std::string& call) {
  return fmt::format("for (std::size_t i = 0; i < sets.size(); ++i) {}", call);
}

Call each(const char* key, const char* name, const std::string& function) {
  return {{key, name}, loop(fmt::format("out[i] = {};", function)), {}};
}

Call sweep(const char* key, const char* name, const std::string& grade) {
  return {
      {key, name},
      loop(fmt::format("{}critical_velocity(sets[i], {{&omegas[i], 1}}, {{&out[i], 1}});", grade)),
      fmt::format("{}critical_velocity(sets[0], omegas, out);", grade)};
}

Call batch(const char* key, const char* name, const std::string& grade) {
  return {{key, name}, fmt::format("{}critical_velocity({{}}, columns, out);", grade), {}};
}

/// Statements with the member of each number of a set.
std::string for_each_number(const std::vector<Symbol>& symbols,
                            const symbolic::ParameterList& parameters, const char* statement) {
  std::string text;
  for (std::size_t i = 0; i < symbols.size(); ++i)
    text += fmt::format(fmt::runtime(statement),
                        fmt::arg("member", parameters.reference(symbols[i])), fmt::arg("i", i));
  return text;
}

std::string own_struct(const symbolic::ParameterList& parameters) {
  std::string members;
  for (const symbolic::Member& member : parameters.members())
    members += member.length == 0 ? fmt::format("  double {};\n", member.name)
                                  : fmt::format("  double {}[{}];\n", member.name, member.length);
  return fmt::format("struct Parameters {{\n{}}};\n", members);
}

std::string columns(const std::vector<Symbol>& symbols, const symbolic::ParameterList& parameters) {
  const std::string numbers = std::to_string(symbols.size());
  return "  std::vector<double> numbers[" + numbers + "];\n  for (const Parameters& p : sets) {\n" +
         for_each_number(symbols, parameters, "    numbers[{i}].push_back({member});\n") +
         "  }\n  scene::Columns columns;\n  {\n    scene::Columns& p = columns;\n" +
         for_each_number(symbols, parameters, "    {member} = numbers[{i}].data();\n") + "  }\n";
}

std::string answers(const std::vector<Call>& calls) {
  std::string text =
      "  for (int i = 3; i < count; ++i) {\n    const std::string_view key = words[i];\n";
  for (const Call& call : calls)
    text += fmt::format(
        "    if (key == \"{}\")\n      answer(file, out, [&] {{ {} }}, [&] {{ {} }});\n",
        call.way.key, call.values, call.timed.empty() ? call.values : call.timed);
  return text + "  }\n  return std::fclose(file);\n}\n";
}

}  // namespace

const std::vector<Call>& generated_calls() {
  static const std::vector<Call> calls{
      each("accurate", "generated, accurate", "scene::critical_velocity(sets[i])"),
      batch("accurate_batch", "generated, accurate, batch", "scene::"),
      sweep("accurate_sweep", "generated, accurate, sweep", "scene::"),
      each("certified", "generated, certified",
           "scene::critical_velocity_certified(sets[i]).value"),
      each("fast", "generated, fast", "scene::fast::critical_velocity(sets[i])"),
      batch("fast_batch", "generated, fast, batch", "scene::fast::"),
      sweep("fast_sweep", "generated, fast, sweep", "scene::fast::")};
  return calls;
}

const std::vector<Call>& bound_calls() {
  static const std::vector<Call> calls{
      each("certified_bound", "bound of the accurate grade",
           "scene::critical_velocity_certified(sets[i]).relative_error_bound"),
      each("fast_bound", "bound of the fast grade",
           "scene::fast::critical_velocity_certified(sets[i]).relative_error_bound")};
  return calls;
}

const Call& complex_call() {
  static const Call call =
      each("complex", "Eq. 24 in std::complex, as written", "in_complex_numbers(sets[i])");
  return call;
}

const Call& pasted_call() {
  static const Call call =
      each("pasted", "the derived formula, pasted", "derived_formula(sets[i])");
  return call;
}

std::string driver_source(const Scene& scene, const symbolic::Derivation& nested,
                          const symbolic::Derivation& formula, const std::vector<Symbol>& symbols,
                          const std::vector<Call>& calls, bool has_generated) {
  const symbolic::ParameterList parameters(scene, formula);
  std::string text = includes;
  text += has_generated ? "#include \"scene_batch.hpp\"\nusing scene::Parameters;\n"
                        : own_struct(parameters);
  text += pasted_preamble() + pasted_function("in_complex_numbers", nested, parameters);
  if (formula.definitions.empty()) text += pasted_function("derived_formula", formula, parameters);
  text += "static bool read(std::FILE* in, Parameters& p) {\n  return true" +
          for_each_number(symbols, parameters,
                          " &&\n         std::fscanf(in, \"%la\", &{member}) == 1") +
          ";\n}\n";
  text += measuring;
  text += main_begins;
  if (has_generated) text += columns(symbols, parameters);
  return text + answers(calls);
}

}  // namespace vcrit::validation::accuracy
