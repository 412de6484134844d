#include "evaluators.hpp"

#include <fmt/core.h>

#include <sstream>
#include <stdexcept>

#include "base/files.hpp"
#include "base/numbers.hpp"
#include "compiler.hpp"
#include "emit/generate.hpp"
#include "formula/symbols.hpp"
#include "formula/value.hpp"

namespace vcrit::validation {

namespace {

/// GiNaC's working precision is one global number.
class Precision {
 public:
  explicit Precision(long digits) : before_(GiNaC::Digits) { GiNaC::Digits = digits; }
  ~Precision() { GiNaC::Digits = before_; }
  Precision(const Precision&) = delete;
  Precision& operator=(const Precision&) = delete;

 private:
  long before_;
};

constexpr std::chrono::seconds run_limit{10};

std::string member(const Symbol& symbol) {
  return symbol.entry == 0 ? symbol.name : fmt::format("{}[{}]", symbol.name, symbol.entry - 1);
}

GeneratedVelocities parse(const std::string& output) {
  std::istringstream words(output);
  const auto next = [&] {
    std::string word;
    words >> word;
    const auto value = to_double(word);
    if (!value) throw std::runtime_error("the generated program printed \"" + output + "\"");
    return *value;
  };
  GeneratedVelocities velocities;
  for (double* value : {&velocities.accurate, &velocities.batch, &velocities.fast,
                        &velocities.certified, &velocities.certified_bound})
    *value = next();
  return velocities;
}

/// R_d between two rows of its table, as exact as the table's doubles.
GiNaC::ex interpolated(const Receptance& receptance, double omega) {
  const auto [below, above] = bracket(receptance, omega);
  const auto complex = [](const Receptance::Row& row) {
    return symbolic::exact_binary(row.re) + symbolic::exact_binary(row.im) * GiNaC::I;
  };
  if (below.omega == above.omega) return complex(below);
  const GiNaC::numeric from = symbolic::exact_binary(below.omega);
  const GiNaC::numeric share =
      (symbolic::exact_binary(omega) - from) / (symbolic::exact_binary(above.omega) - from);
  return complex(below) * (1 - share) + complex(above) * share;
}

}  // namespace

double value_in_digits(const GiNaC::ex& formula, const std::vector<symbolic::Line>& definitions,
                       const Values& values, long digits) {
  const Precision precision(digits);
  std::map<Symbol, GiNaC::numeric> numbers;
  for (const auto& [symbol, value] : values) numbers[symbol] = GiNaC::numeric(value);
  const GiNaC::numeric value = symbolic::value_at(formula, definitions, numbers);
  if (!value.is_real()) throw std::runtime_error("the derived formula gave no real number");
  return value.to_double();
}

double derived_velocity(const Scene& scene, const symbolic::Derivation& derivation,
                        const Values& values, long digits) {
  std::vector<symbolic::Line> definitions;
  if (scene.receptance)
    definitions.push_back(
        {"", symbolic::quantity("R_d"),
         interpolated(*scene.receptance, values.at(scene.angular_frequency.symbol))});
  definitions.insert(definitions.end(), derivation.definitions.begin(),
                     derivation.definitions.end());
  return value_in_digits(derivation.critical_velocity, definitions, values, digits);
}

std::string asking_program(const std::vector<Symbol>& parameters, const Values& values) {
  std::string assignments;
  for (const Symbol& symbol : parameters)
    assignments += fmt::format("  p.{} = {:a};\n", member(symbol), values.at(symbol));
  return "#include <cstdio>\n#include \"scene.hpp\"\n" + fmt::format(R"(
int main() {{
  scene::Parameters p{{}};
{}  const double omega = p.omega;
  double batch = 0;
  scene::critical_velocity(p, {{&omega, 1}}, {{&batch, 1}});
  const auto certified = scene::critical_velocity_certified(p);
  for (double v : {{scene::critical_velocity(p), batch, scene::fast::critical_velocity(p),
                   certified.value, certified.relative_error_bound}})
    std::printf("%.17g\n", v);
}}
)",
                                                                     assignments);
}

GeneratedVelocities generated_velocities(const Scene& scene, const symbolic::Derivation& derivation,
                                         const Values& values,
                                         const std::filesystem::path& compiler,
                                         const std::filesystem::path& folder) {
  symbolic::generate(scene, folder, "scene");
  write_file(folder / "ask.cpp", asking_program(derivation.parameters, values));
  output_or_throw(compile(compiler, folder, "ask.cpp", "ask"), "compiling the generated evaluator");
  return parse(
      output_or_throw(run_program({folder / "ask"}, folder, run_limit), "the generated evaluator"));
}

}  // namespace vcrit::validation
