#include "compare/evaluators.hpp"

#include <fmt/core.h>

#include <stdexcept>

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

double derived_velocity(const symbolic::Derivation& derivation, const Values& values, long digits) {
  const Problem& problem = derivation.problem;
  std::vector<symbolic::Line> definitions;
  if (problem->receptance() != nullptr)
    definitions.push_back(
        {"", symbolic::quantity("R_d"),
         interpolated(*problem->receptance(), values.at(problem->angular_frequency.symbol))});
  definitions.insert(definitions.end(), derivation.definitions.begin(),
                     derivation.definitions.end());
  return value_in_digits(derivation.critical_velocity, definitions, values, digits);
}

GeneratedVelocities generated_velocities(const Driver& driver, const Values& values) {
  std::vector<double> set;
  for (const Symbol& symbol : driver.symbols()) set.push_back(values.at(symbol));
  const auto answers = driver.run({set}, {"accurate", "accurate_sweep", "fast", "certified"});
  const auto answer = [&](std::size_t way) { return answers[way].values.front(); };
  return {answer(0), answer(1), answer(2), answer(3), driver.bounds({set}, "certified").front()};
}

}  // namespace vcrit::validation
