#include "analysis/by_frequency.hpp"

#include <utility>
#include <vector>

#include "analysis/abbreviated.hpp"
#include "formula/symbols.hpp"
#include "network/polynomial.hpp"
#include "polynomial/symbol_ring.hpp"

namespace vcrit::symbolic {

namespace {

using GiNaC::ex;

// Longer ones are not read.
constexpr std::size_t most_terms_by_frequency = 100;

/// number * product(base^exponent)
struct FactoredSum {
  ex number;
  std::vector<std::pair<ex, int>> powers;
};

FactoredSum factored_sum(const ex& sum) {
  const GiNaC::numeric content = sum.integer_content().is_zero()
                                     ? GiNaC::numeric(1)
                                     : GiNaC::ex_to<GiNaC::numeric>(sum.integer_content());
  const ex whole = (sum / content).expand();
  const SymbolRing ring({whole});
  const FactoredPolynomial found = polynomial_factors(ring.polynomial(whole));
  FactoredSum result{content * GiNaC::numeric(found.constant.c_str()), {}};
  for (const auto& [factor, exponent] : found.factors)
    result.powers.emplace_back(ring.sum(factor), static_cast<int>(exponent));
  return result;
}

ex product_of(const FactoredSum& factors) {
  ex product = factors.number;
  for (const auto& [base, exponent] : factors.powers) product *= GiNaC::pow(base, exponent);
  return product;
}

/// Its coefficients of the powers of omega as products.
ex sum_by_powers(const ex& sum) {
  ex result = 0;
  for (int power = sum.ldegree(omega()); power <= sum.degree(omega()); ++power)
    if (const ex coefficient = sum.coeff(omega(), power); !coefficient.is_zero())
      result += product_of(factored_sum(coefficient)) * GiNaC::pow(omega(), power);
  return result;
}

}  // namespace

ex by_frequency(const ex& polynomial) {
  const ex sum = polynomial.expand();
  if (!GiNaC::is_a<GiNaC::add>(sum) || sum.nops() > most_terms_by_frequency) return polynomial;
  FactoredSum factors = factored_sum(sum);
  for (auto& [base, exponent] : factors.powers) base = sum_by_powers(base);
  const ex shorter = product_of(factors);
  return printed_operations(shorter) < printed_operations(polynomial) ? shorter : polynomial;
}

ex factors_by_frequency(const ex& product) {
  if (GiNaC::is_a<GiNaC::add>(product)) return by_frequency(product);
  if (GiNaC::is_a<GiNaC::power>(product) && product.op(1).info(GiNaC::info_flags::integer))
    return GiNaC::pow(by_frequency(product.op(0)), product.op(1));
  if (!GiNaC::is_a<GiNaC::mul>(product)) return product;
  ex result = 1;
  for (const ex& factor : product) result *= factors_by_frequency(factor);
  return result;
}

}  // namespace vcrit::symbolic
