#include "analysis/expanded.hpp"

#include <map>
#include <string>

#include "analysis/rational_form.hpp"
#include "analysis/rational_lines.hpp"
#include "derivation/factors.hpp"
#include "derivation/model.hpp"
#include "formula/algebra_lock.hpp"
#include "formula/symbols.hpp"
#include "rules/rulebook.hpp"

namespace vcrit::symbolic {

namespace {

// Terms of a polynomial whose factors are looked for.
constexpr std::size_t most_split = 400;

void multiply_factors(Factors& whole, const Polynomial& polynomial, int exponent,
                      const GiNaC::exmap& ratio) {
  FactoredPolynomial product{"1", {{polynomial, 1}}};
  if (polynomial.terms() <= most_split) product = polynomial_factors(polynomial);
  whole.multiply(GiNaC::numeric(product.constant.c_str()), exponent);
  for (const auto& [factor, power] : product.factors)
    for (unsigned long i = 0; i < power; ++i)
      whole.multiply(expression(factor).subs(ratio), exponent);
}

/// Poisson's ratio may be negative, as other symbols are not.
GiNaC::exmap ratio_of(const Problem& problem) {
  const auto* isotropic = std::get_if<Isotropic>(&problem->tangential);
  if (isotropic == nullptr || isotropic->quantity.value || isotropic->by != Isotropic::By::poisson)
    return {};
  return {{symbol(isotropic->quantity.symbol), poisson_ratio(isotropic->quantity.symbol)}};
}

}  // namespace

Derivation expanded_form(Derivation derivation, double budget) {
  const AlgebraLock lock;
  if (derivation.definitions.empty()) return derivation;
  rules::require(rules::Question::rational_form, derivation.problem);
  const Amplitude amplitude = multiplied_out(*derivation.model, budget);
  const GiNaC::exmap ratio = ratio_of(derivation.problem);
  Factors factors;
  multiply_factors(factors, amplitude.per_friction.over, 1, ratio);
  multiply_factors(factors, amplitude.per_friction.under, -1, ratio);
  derivation.critical_velocity = symbol({"mu0"}) * symbol({"du_z"}) * omega() * factors.modulus();
  derivation.lines.back().right = derivation.critical_velocity;
  derivation.definitions.clear();
  return derivation;
}

}  // namespace vcrit::symbolic
