// Generated headers, compiled together into one driver program and run on many parameter sets.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "base/files.hpp"
#include "base/numbers.hpp"
#include "derivation/derivation.hpp"
#include "emit/asked.hpp"
#include "emit/generate.hpp"
#include "emit/parameters.hpp"
#include "support/nodal.hpp"
#include "support/numbers.hpp"
#include "support/program.hpp"

namespace vcrit::test {

inline const std::vector<std::string> strict_flags{
    "-std=c++20", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Werror"};

/// What takes a compiler least, for the plainest processor: on x86-64 one without fma.
inline const std::vector<std::string> plainest_flags{
    "-O0",
#ifdef __x86_64__
    "-march=x86-64",
#endif
};

inline std::vector<std::string> compilers(const PrivateFolder& folder) {
  const std::vector<std::string> names{"g++", "clang++"};
  for (const std::string& name : names) require_tool(name, folder.path());
  return names;
}

/// How the processor rounds and treats subnormal numbers around the calls.
struct ArithmeticState {
  std::string rounding = "FE_TONEAREST";
  bool flush_to_zero = false;  ///< results and operands; of the processors, x86-64 alone has a test
};

/// One call of a generated library: the scene with all values, and what the functions gave.
struct Call {
  std::size_t library = 0;
  Scene scene;
  double value = 0, bound = 0, fast_value = 0, fast_bound = 0;
  /// In the order of the members of Parameters; empty where gradients are not asked for.
  std::vector<double> partials, fast_partials;
};

/// The scene's values in the order of the members of Parameters; entries of arrays that the scene
/// leaves out are 0.
inline std::vector<double> members(const Scene& scene, const symbolic::ParameterList& parameters) {
  Values values;  // by the names that evaluators have
  for (const auto& [symbol, value] : test::numbers_of(scene))
    values[as_called(scene, symbol)] = value;
  std::vector<double> result;
  for (const symbolic::Member& member : parameters.members())
    for (int entry = member.length == 0 ? 0 : 1; entry <= member.length; ++entry) {
      const double* const value = values.find({member.name, entry});
      result.push_back(value == nullptr ? 0.0 : *value);
    }
  return result;
}

class Libraries {
 public:
  /// With options for each scene, or none.
  explicit Libraries(std::vector<Scene> scenes, Asked asked = Asked::values,
                     std::vector<symbolic::GenerateOptions> options = {})
      : scenes_(std::move(scenes)), asked_(asked), options_(std::move(options)) {
    options_.resize(scenes_.size());
    for (std::size_t i = 0; i < scenes_.size(); ++i) {
      const symbolic::Derivation derivation = symbolic::derive(scenes_[i]);
      parameters_.emplace_back(scenes_[i], derivation,
                               symbolic::fixed_values(scenes_[i], options_[i].fixed));
      write_file(header(i), symbolic::emit_header(derivation, name(i), options_[i]));
    }
    write_file(folder_.path() / "driver.cpp", driver());
  }

  const PrivateFolder& folder() const { return folder_; }
  std::filesystem::path header(std::size_t i) const { return folder_.path() / (name(i) + ".hpp"); }
  std::size_t size() const { return scenes_.size(); }
  const Scene& scene(std::size_t i) const { return scenes_[i]; }
  std::vector<double> members_of(const Call& call) const {
    return members(call.scene, parameters_[call.library]);
  }

  /// Compiles the driver; returns the compiler's complaints.
  std::string compile(const std::string& compiler, const std::vector<std::string>& flags) const {
    std::vector<std::string> command{compiler};
    command.insert(command.end(), strict_flags.begin(), strict_flags.end());
    command.insert(command.end(), flags.begin(), flags.end());
    for (const char* word : {"-o", "driver", "driver.cpp"}) command.emplace_back(word);
    for (std::string& word : command)
      if (word == "driver" || word == "driver.cpp") word = (folder_.path() / word).string();
    const Outcome outcome = run(command, folder_.path());
    return outcome.status == 0 ? "" : outcome.output + " ";
  }

  /// Fills in the results; fails where a function leaves another arithmetic behind.
  void evaluate(std::vector<Call>& calls, const ArithmeticState& state = {}) const {
    std::string input;
    for (const Call& call : calls) {
      input += std::to_string(call.library);
      for (const double x : members_of(call)) input += fmt::format(" {}", to_text(x));
      input += "\n";
    }
    const std::string file = (folder_.path() / "input.txt").string();
    write_file(file, input);
    const Outcome outcome = run(
        {(folder_.path() / "driver").string(), state.rounding, state.flush_to_zero ? "flush" : ""},
        folder_.path(), file);
    if (outcome.status != 0) throw std::runtime_error("driver failed: " + outcome.output);
    std::istringstream lines(outcome.output);
    const auto next = [&lines] {
      std::string word;
      lines >> word;
      return std::strtod(word.c_str(), nullptr);
    };
    for (Call& call : calls) {
      for (double* result : {&call.value, &call.bound, &call.fast_value, &call.fast_bound})
        *result = next();
      if (asked_ == Asked::values) continue;
      for (std::vector<double>* partials : {&call.partials, &call.fast_partials}) {
        partials->resize(members_of(call).size());
        for (double& partial : *partials) partial = next();
      }
    }
  }

 private:
  static std::string name(std::size_t i) { return "scene_" + std::to_string(i); }

  std::string gradients(const std::string& name) const {
    if (asked_ == Asked::values) return "";
    return fmt::format(", {0}::critical_velocity_gradient, {0}::fast::critical_velocity_gradient",
                       name);
  }

  std::string driver() const {
    std::string out;
    for (std::size_t i = 0; i < scenes_.size(); ++i) out += "#include \"" + name(i) + ".hpp\"\n";
    // Small headers: many drivers are compiled, and <immintrin.h> alone takes half a second.
    out += R"(#include <cfenv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#ifdef __SSE2__
#include <xmmintrin.h>
unsigned control() { return _mm_getcsr() & ~0x3Fu; }  // without the flags of what happened
void flush_to_zero() { _mm_setcsr(_mm_getcsr() | 0x8040u); }
#else
unsigned control() { return static_cast<unsigned>(std::fegetround()); }
void flush_to_zero() {}
#endif
bool flush = false;
int rounding = FE_TONEAREST;

// Volatile: nothing is computed before or after the arithmetic has been changed.
template <class Function, class Parameters>
auto within(Function function, const Parameters& parameters) {
  std::fenv_t before;
  std::fegetenv(&before);
  std::fesetround(rounding);
  if (flush) flush_to_zero();
  const unsigned set = control();
  const Parameters* volatile here = &parameters;
  Function volatile called = function;
  const auto result = called(*here);
  if (control() != set) std::exit(2);
  std::fesetenv(&before);
  return result;
}

template <class Parameters, class Function, class... Gradient>
void call(Function accurate, Function fast, Gradient... gradients) {
  double x[sizeof(Parameters) / sizeof(double)];
  char word[64];
  for (double& each : x) {
    if (std::scanf("%63s", word) != 1) std::exit(1);
    each = std::strtod(word, nullptr);
  }
  Parameters p;
  std::memcpy(&p, x, sizeof p);
  const auto a = within(accurate, p);
  const auto f = within(fast, p);
  std::printf("%a %a %a %a\n", a.value, a.relative_error_bound, f.value, f.relative_error_bound);
  [[maybe_unused]] const auto print = [&x](const Parameters& partials) {
    std::memcpy(x, &partials, sizeof partials);
    for (double each : x) std::printf("%a\n", each);
  };
  (print(within(gradients, p).partial), ...);
}

#define MODE(NAME) if (std::strcmp(arguments[1], #NAME) == 0) rounding = NAME
int main(int, char** arguments) {
  rounding = -1;
  MODE(FE_TONEAREST);
  MODE(FE_UPWARD);
  MODE(FE_DOWNWARD);
  MODE(FE_TOWARDZERO);
  if (rounding == -1) return 1;
  flush = std::strcmp(arguments[2], "flush") == 0;
  int scene = 0;
  while (std::scanf("%d", &scene) == 1) {
)";
    for (std::size_t i = 0; i < scenes_.size(); ++i)
      out += fmt::format(
          "    if (scene == {0})\n"
          "      call<{1}::Parameters>({1}::critical_velocity_certified,\n"
          "                            {1}::fast::critical_velocity_certified{2});\n",
          i, name(i), gradients(name(i)));
    return out + "  }\n}\n";
  }

  PrivateFolder folder_;
  std::vector<Scene> scenes_;
  Asked asked_;
  std::vector<symbolic::GenerateOptions> options_;
  std::vector<symbolic::ParameterList> parameters_;
};

}  // namespace vcrit::test
