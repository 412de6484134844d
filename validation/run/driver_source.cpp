#include "run/driver_source.hpp"

#include <fmt/core.h>

#include "derivation/derivation.hpp"
#include "emit/parameters.hpp"
#include "run/pasted.hpp"

namespace vcrit::validation {

namespace {

// No more: each scene pays for what they hold. <vector> and <algorithm>, with what is made of them,
// take a tenth of a compiler's time.
const char* const includes = R"(#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
)";

const char* const numbers_of_all = R"(
static std::size_t count;
static Parameters* sets;
static double *omegas, *out;
)";

// One pass over thousands of sets takes longer than the clock's grain; the first one warms up.
const char* const measuring = R"(
static double now() {
  std::timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return 1e9 * static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec);
}
static double time_of(void (*run)()) {
  double times[9];
  for (double& time : times) {
    const double begin = now();
    run();
    time = now() - begin;
  }
  std::qsort(times, 9, sizeof *times, [](const void* a, const void* b) {
    const double x = *static_cast<const double*>(a), y = *static_cast<const double*>(b);
    return x < y ? -1 : x > y ? 1 : 0;
  });
  return times[4] / static_cast<double>(count);
}
static void answer(std::FILE* file, void (*values)(), void (*timed)()) {
  for (std::size_t i = 0; i < count; ++i) out[i] = NAN;
  values();
  for (std::size_t i = 0; i < count; ++i) std::fprintf(file, "%a\n", out[i]);
  std::fprintf(file, "%a\n", time_of(timed));
}
)";

const char* const main_begins = R"(
int main(int number, char** words) {
  std::FILE* const in = std::fopen(words[1], "r");
  std::FILE* const file = std::fopen(words[2], "w");
  if (in == nullptr || file == nullptr || std::fscanf(in, "%zu", &count) != 1) return 1;
  sets = new Parameters[count];
  omegas = new double[count];
  out = new double[count];
  for (std::size_t i = 0; i < count; ++i) {
    if (!read(in, sets[i])) return 1;
    omegas[i] = sets[i].omega;
  }
)";

const char* const main_ends = R"(
  for (int i = 3; i < number; ++i)
    for (const Way& way : ways)
      if (std::strcmp(way.key, words[i]) == 0) answer(file, way.values, way.timed);
  return std::fclose(file);
}
)";

std::string loop(const std::string& call) {
  return fmt::format("for (std::size_t i = 0; i < count; ++i) {}", call);
}

Call each(const char* key, const char* name, const std::string& function, bool unhurried = false) {
  return {{key, name}, loop(fmt::format("out[i] = {};", function)), {}, unhurried};
}

Call sweep(const char* key, const char* name, const std::string& grade) {
  return {
      {key, name},
      loop(fmt::format("{}critical_velocity(sets[i], {{&omegas[i], 1}}, {{&out[i], 1}});", grade)),
      fmt::format("{}critical_velocity(sets[0], {{omegas, count}}, {{out, count}});", grade)};
}

Call batch(const char* key, const char* name, const std::string& grade) {
  return {
      {key, name}, fmt::format("{}critical_velocity({{}}, columns, {{out, count}});", grade), {}};
}

/// Statements with the member of each number of a set.
std::string statement_for_each(const std::vector<Symbol>& symbols,
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

// A parameter of all sets, from where the first one has it.
const char* const column = R"([[gnu::noinline]] static const double* column(const double& first) {
  double* const values = new double[count];
  const char* from = reinterpret_cast<const char*>(&first);
  for (std::size_t i = 0; i < count; ++i, from += sizeof(Parameters)) std::memcpy(values + i, from, sizeof(double));
  return values;
}
)";

std::string fill_columns(const std::vector<Symbol>& symbols,
                         const symbolic::ParameterList& parameters) {
  return "  const double* numbers[" + std::to_string(symbols.size()) +
         "];\n  {\n    const Parameters& p = *sets;\n" +
         statement_for_each(symbols, parameters, "    numbers[{i}] = column({member});\n") +
         "  }\n  {\n    scene::Columns& p = columns;\n" +
         statement_for_each(symbols, parameters, "    {member} = numbers[{i}];\n") + "  }\n";
}

/// A function for each way, and one for what is timed in its place. Where time is of no interest
/// the compiler need not take any to save it.
std::string functions(const std::vector<Call>& calls) {
  std::string text, ways;
  for (const Call& call : calls) {
    const std::string& key = call.way.key;
    text += fmt::format("{}static void {}_values() {{ {} }}\n",
                        call.unhurried || !call.timed.empty() ? "[[gnu::cold]] " : "", key,
                        call.values);
    if (!call.timed.empty())
      text += fmt::format("static void {}_timed() {{ {} }}\n", key, call.timed);
    ways += fmt::format("    {{\"{0}\", {0}_values, {0}_{1}}},\n", key,
                        call.timed.empty() ? "values" : "timed");
  }
  return text +
         "struct Way {\n  const char* key;\n  void (*values)();\n  void (*timed)();\n};\n"
         "static const Way ways[] = {\n" +
         ways + "};\n";
}

/// The relative error bounds that both grades of the library claim.
const std::vector<Call>& bound_calls() {
  static const std::vector<Call> calls{
      each("certified_bound", "bound of the accurate grade",
           "scene::critical_velocity_certified(sets[i]).relative_error_bound", true),
      each("fast_bound", "bound of the fast grade",
           "scene::fast::critical_velocity_certified(sets[i]).relative_error_bound", true)};
  return calls;
}

std::vector<Call> calls_of(const symbolic::Derivation& formula, bool has_generated) {
  std::vector<Call> calls{complex_call()};
  if (formula.definitions.empty()) calls.push_back(pasted_call());
  if (!has_generated) return calls;
  for (const std::vector<Call>& more : {generated_calls(), bound_calls()})
    calls.insert(calls.end(), more.begin(), more.end());
  return calls;
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

const Call& complex_call() {
  static const Call call =
      each("complex", "Eq. 24 in complex doubles, as written", "in_complex_numbers(sets[i])");
  return call;
}

const Call& pasted_call() {
  static const Call call =
      each("pasted", "the derived formula, pasted", "derived_formula(sets[i])");
  return call;
}

std::string driver_source(const symbolic::Derivation& formula, bool has_generated) {
  const symbolic::ParameterList parameters(formula.problem, formula);
  const std::vector<Symbol>& symbols = formula.parameters;
  std::string text = includes;
  text += has_generated ? "#include \"scene_batch.hpp\"\nusing scene::Parameters;\n"
                          "static scene::Columns columns;\n"
                        : own_struct(parameters);
  text += pasted_preamble(formula.problem) +
          pasted_function("in_complex_numbers", symbolic::nested_form(formula), parameters);
  if (formula.definitions.empty()) text += pasted_function("derived_formula", formula, parameters);
  text += "static bool read(std::FILE* in, Parameters& p) {\n  return true" +
          statement_for_each(symbols, parameters,
                             " &&\n         std::fscanf(in, \"%la\", &{member}) == 1") +
          ";\n}\n";
  text += numbers_of_all + functions(calls_of(formula, has_generated)) + measuring;
  if (has_generated) text += column;
  text += main_begins;
  if (has_generated) text += fill_columns(symbols, parameters);
  return text + main_ends;
}

}  // namespace vcrit::validation
