#include "derivation/factors.hpp"

#include <algorithm>

#include "base/errors.hpp"
#include "formula/form.hpp"
#include "formula/symbols.hpp"
#include "polynomial/symbol_ring.hpp"

namespace vcrit::symbolic {

namespace {

using GiNaC::ex;

std::map<std::string, ex> symbols_in(const ex& expression) {
  std::map<std::string, ex> found;
  for (auto it = expression.preorder_begin(); it != expression.preorder_end(); ++it)
    if (GiNaC::is_a<GiNaC::symbol>(*it))
      found.emplace(GiNaC::ex_to<GiNaC::symbol>(*it).get_name(), *it);
  return found;
}

bool is_positive_symbol(const ex& expression) {
  return GiNaC::is_a<GiNaC::symbol>(expression) && expression.info(GiNaC::info_flags::positive);
}

bool is_ratio(const ex& symbol) {
  return symbol.info(GiNaC::info_flags::real) && !is_positive_symbol(symbol);
}

bool all_terms_positive(const ex& f) {
  if (!GiNaC::is_a<GiNaC::add>(f)) return !leads_with_minus(f);
  return std::all_of(f.begin(), f.end(), [](const ex& term) { return !leads_with_minus(term); });
}

/// Whether a real polynomial is positive for all positive symbols because every coefficient is. A
/// real symbol is a Poisson's ratio: what is linear in it is positive if both ends of (-1, 1/2]
/// are.
bool is_positive(const ex& f) {
  for (const auto& [name, symbol] : symbols_in(f)) {
    if (is_positive_symbol(symbol)) continue;
    if (f.degree(symbol) > 1) return false;
    return is_positive(f.subs(symbol == -1).expand()) &&
           is_positive(f.subs(symbol == GiNaC::numeric(1, 2)).expand());
  }
  return all_terms_positive(f);
}

bool is_complex(const ex& f) {
  const auto symbols = symbols_in(f);
  return std::any_of(symbols.begin(), symbols.end(), [](const auto& entry) {
    return !entry.second.is_equal(laplace()) && !entry.second.info(GiNaC::info_flags::real);
  });
}

ex squared(const ex& polynomial) { return GiNaC::pow(factored_polynomial(polynomial), 2); }

/// |f| = factor |value|, or factor sqrt(value) where f is complex.
struct Modulus {
  bool is_square = false;
  ex value, factor = 1;
};

/// even^2 + omega^2 odd^2
Modulus squared_sum(const EvenOdd& parts) {
  const ex w = omega();
  if (parts.even.ldegree(w) == 0)
    return {true, squared(parts.even) + GiNaC::pow(w, 2) * squared(parts.odd)};
  return {true, squared((parts.even / w).expand()) + squared(parts.odd), w};
}

Modulus modulus_of(const ex& f) {
  if (is_complex(f)) return {false, GiNaC::abs(f.subs(laplace() == GiNaC::I * omega()))};
  const EvenOdd parts = even_odd(f);
  if (!parts.odd.is_zero() && !parts.even.is_zero()) return squared_sum(parts);
  const ex real = parts.odd.is_zero() ? parts.even : (omega() * parts.odd).expand();
  return {false, is_positive(real) ? real : ex(GiNaC::abs(real))};
}

}  // namespace

ex factored(const ex& rational) {
  Factors factors;
  factors.multiply_rational(rational);
  factors.cancel();
  return factors.value();
}

ex factored_polynomial(const ex& polynomial) {
  Factors factors;
  factors.multiply(polynomial, 1);
  return factors.value();
}

// Poisson's ratio has values up to 1/2, everything else has 1.
bool is_negative(const ex& expression) {
  GiNaC::exmap sample;
  for (const auto& [name, symbol] : symbols_in(expression))
    sample[symbol] = is_ratio(symbol) ? ex(GiNaC::numeric(1, 4)) : ex(1);
  return expression.subs(sample).info(GiNaC::info_flags::negative);
}

ex by_letter(const ex& formula, const ex& letter) {
  if (GiNaC::is_a<GiNaC::function>(formula))
    return GiNaC::abs(formula.op(0).expand().collect(letter));
  GiNaC::exmap collected;
  for (auto part = formula.preorder_begin(); part != formula.preorder_end(); ++part)
    if (GiNaC::is_a<GiNaC::function>(*part)) collected[*part] = by_letter(*part, letter);
  return formula.subs(collected, GiNaC::subs_options::no_pattern);
}

EvenOdd even_odd(const ex& f) {
  EvenOdd parts;
  const ex s = laplace(), w = omega();
  for (int n = 0; n <= f.degree(s); ++n) {
    const ex term = f.coeff(s, n) * (n / 2 % 2 == 0 ? 1 : -1);
    if (n % 2 == 0)
      parts.even += term * GiNaC::pow(w, n);
    else
      parts.odd += term * GiNaC::pow(w, n - 1);
  }
  return {parts.even.expand(), parts.odd.expand()};
}

void Factors::multiply(const ex& polynomial, int exponent) {
  ex rest = polynomial.expand();
  ensure(exponent > 0 || !rest.is_zero(), "no division by zero");
  if (rest.is_zero()) {
    coefficient_ = 0;
    return;
  }
  const auto symbols = symbols_in(rest);
  for (const auto& [name, symbol] : symbols) {
    const int low = rest.ldegree(symbol);
    if (low == 0) continue;
    rest = (rest / GiNaC::pow(symbol, low)).expand();
    auto& entry = monomial_.try_emplace(name, symbol, 0).first->second;
    entry.second += exponent * low;
  }
  if (std::none_of(symbols.begin(), symbols.end(),
                   [](const auto& e) { return is_ratio(e.second); }))
    return put(rest, exponent);
  // What depends on Poisson's ratio alone, 1 - nu, comes out of (1 - nu)(k - m omega^2).
  std::vector<ex> others;
  for (const auto& [name, symbol] : symbols)
    if (!is_ratio(symbol)) others.push_back(symbol);
  for (const ex& factor : split_by(rest, others)) put(factor, exponent);
}

void Factors::put(ex polynomial, int exponent) {
  GiNaC::numeric content = polynomial.integer_content();
  if (leads_with_minus(polynomial)) content = -content;
  coefficient_ *= GiNaC::pow(content, GiNaC::numeric(exponent));
  if (!content.is_equal(1)) polynomial = (polynomial / content).expand();
  if (!polynomial.is_equal(1)) (exponent > 0 ? over_ : under_).push_back(polynomial);
}

void Factors::multiply_rational(const ex& function) {
  const LowestTerms fraction = lowest_terms(function);
  multiply(fraction.over, 1);
  multiply(fraction.under, -1);
}

void Factors::multiply_product(const ex& product) {
  if (!GiNaC::is_a<GiNaC::mul>(product)) return multiply_rational(product);
  for (const ex& factor : product) multiply_rational(factor);
}

void Factors::cancel() {
  struct Polynomial {
    ex left;
    bool whole = true;
  };
  const std::vector<ex> over = std::move(over_);
  std::vector<Polynomial> under;
  for (const ex& below : under_) under.push_back({below});
  over_.clear();
  under_.clear();
  for (const ex& each : over) {
    Polynomial above{each};
    for (Polynomial& below : under) {
      const CommonFactor shared = common_factor(above.left, below.left);
      if (GiNaC::is_a<GiNaC::numeric>(shared.common)) continue;
      above = {shared.a_left, false};
      below = {shared.b_left, false};
    }
    if (above.whole)
      over_.push_back(each);
    else
      multiply(above.left, 1);
  }
  for (const Polynomial& below : under) {
    if (below.whole)
      under_.push_back(below.left);
    else
      multiply(below.left, -1);
  }
}

std::vector<std::pair<ex, int>> Factors::parts() const {
  std::vector<std::pair<ex, int>> result;
  for (const auto& [name, entry] : monomial_)
    if (entry.second != 0) result.push_back(entry);
  for (const ex& f : over_) result.emplace_back(f, 1);
  for (const ex& f : under_) result.emplace_back(f, -1);
  return result;
}

ex Factors::value() const {
  ex result = coefficient_;
  for (const auto& [factor, exponent] : parts()) result *= GiNaC::pow(factor, exponent);
  return result;
}

ex Factors::modulus() const {
  ex plain = GiNaC::abs(coefficient_), over_root = 1, under_root = 1;
  for (const auto& [name, entry] : monomial_) {
    const auto& [symbol, exponent] = entry;
    const ex size = symbol.is_equal(laplace())   ? omega()
                    : is_positive_symbol(symbol) ? symbol
                                                 : ex(GiNaC::abs(symbol));
    plain *= GiNaC::pow(size, exponent);
  }
  for (const ex& f : over_) {
    const Modulus m = modulus_of(f);
    (m.is_square ? over_root : plain) *= m.value;
    plain *= m.factor;
  }
  for (const ex& f : under_) {
    const Modulus m = modulus_of(f);
    if (m.is_square)
      under_root *= m.value;
    else
      plain /= m.value;
    plain /= m.factor;
  }
  return plain * GiNaC::sqrt(over_root / under_root);
}

}  // namespace vcrit::symbolic
