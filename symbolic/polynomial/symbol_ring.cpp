#include "polynomial/symbol_ring.hpp"

#include <algorithm>
#include <map>
#include <sstream>

#include "base/errors.hpp"
#include "base/interruption.hpp"
#include "formula/rational.hpp"
#include "polynomial/quotient_algebra.hpp"

namespace vcrit::symbolic {

namespace {

using GiNaC::ex;

// Numbers of fewer bits are longs.
constexpr int bits_of_longs = 62;

std::string symbol_name(const ex& symbol) { return GiNaC::ex_to<GiNaC::symbol>(symbol).get_name(); }

std::vector<ex> sorted_symbols(const std::vector<ex>& expressions) {
  std::map<std::string, ex> found;
  for (const ex& each : expressions)
    for (auto part = each.preorder_begin(); part != each.preorder_end(); ++part)
      if (GiNaC::is_a<GiNaC::symbol>(*part)) found.emplace(symbol_name(*part), *part);
  std::vector<ex> symbols;
  for (const auto& [name, symbol] : found) symbols.push_back(symbol);
  return symbols;
}

std::vector<std::string> names_of(const std::vector<ex>& symbols) {
  std::vector<std::string> names;
  for (const ex& symbol : symbols) names.push_back(symbol_name(symbol));
  return names;
}

/// Calls `visit` with each term of an expanded sum, or factor of a product, or with the one.
template <class Kind, class Visit>
void for_each_part(const ex& expression, const Visit& visit) {
  if (!GiNaC::is_a<Kind>(expression)) return visit(expression);
  for (const ex& part : expression) visit(part);
}

/// A term with the coefficient's digits, if it is no long.
void push_term(Polynomial& sum, const GiNaC::numeric& coefficient,
               const std::vector<unsigned long>& exponents) {
  ensure(coefficient.is_integer(), "coefficients are integers");
  const fmpz_mpoly_ctx_struct* context = sum.ring().context();
  if (coefficient.int_length() < bits_of_longs)
    return fmpz_mpoly_push_term_si_ui(sum.raw(), coefficient.to_long(), exponents.data(), context);
  std::ostringstream digits;
  digits << coefficient;
  fmpz_t value;
  fmpz_init(value);
  fmpz_set_str(value, digits.str().c_str(), 10);
  fmpz_mpoly_push_term_fmpz_ui(sum.raw(), value, exponents.data(), context);
  fmpz_clear(value);
}

GiNaC::numeric term_coefficient(const Polynomial& sum, std::size_t i) {
  const fmpz* value = sum.raw()->coeffs + i;
  if (!COEFF_IS_MPZ(*value)) return static_cast<long>(*value);
  return {sum.coefficient(i).c_str()};
}

/// Whether the terms that have the variable in one power are a single one, for any power: all that
/// such a polynomial has in common with them is a number, or a product of variables.
bool has_lone_term(const Polynomial& polynomial, std::size_t variable) {
  std::map<unsigned long, int> terms;
  for (std::size_t i = 0; i < polynomial.terms(); ++i) ++terms[polynomial.exponents(i)[variable]];
  return std::any_of(terms.begin(), terms.end(), [](const auto& each) { return each.second == 1; });
}

}  // namespace

SymbolRing::SymbolRing(const std::vector<ex>& expressions)
    : symbols_(sorted_symbols(expressions)), ring_(names_of(symbols_)) {}

std::size_t SymbolRing::index(const ex& symbol) const {
  const auto found = std::find_if(symbols_.begin(), symbols_.end(),
                                  [&](const ex& each) { return each.is_equal(symbol); });
  ensure(found != symbols_.end(), "a ring has the symbols of its polynomials");
  return static_cast<std::size_t>(found - symbols_.begin());
}

Polynomial SymbolRing::polynomial(const ex& expanded) const {
  Polynomial sum(ring_, 0);
  for_each_part<GiNaC::add>(expanded, [&](const ex& term) {
    GiNaC::numeric coefficient = 1;
    std::vector<unsigned long> exponents(symbols_.size());
    for_each_part<GiNaC::mul>(term, [&](const ex& factor) {
      if (GiNaC::is_a<GiNaC::numeric>(factor))
        coefficient *= GiNaC::ex_to<GiNaC::numeric>(factor);
      else if (GiNaC::is_a<GiNaC::power>(factor))
        exponents[index(factor.op(0))] +=
            static_cast<unsigned long>(GiNaC::ex_to<GiNaC::numeric>(factor.op(1)).to_long());
      else
        ++exponents[index(factor)];
    });
    push_term(sum, coefficient, exponents);
  });
  fmpz_mpoly_sort_terms(sum.raw(), ring_.context());
  fmpz_mpoly_combine_like_terms(sum.raw(), ring_.context());
  return sum;
}

ex SymbolRing::sum(const Polynomial& polynomial) const {
  GiNaC::exvector terms;
  for (std::size_t i = 0; i < polynomial.terms(); ++i) {
    GiNaC::exvector factors{term_coefficient(polynomial, i)};
    const std::vector<unsigned long> exponents = polynomial.exponents(i);
    for (std::size_t at = 0; at < exponents.size(); ++at)
      if (exponents[at] > 0)
        factors.push_back(GiNaC::pow(symbols_[at], static_cast<int>(exponents[at])));
    terms.push_back(GiNaC::mul(factors));
  }
  return GiNaC::add(terms);
}

WholePolynomial whole_of(const ex& polynomial) {
  const ex content = polynomial.integer_content();
  if (content.info(GiNaC::info_flags::integer)) return {polynomial, 1};
  return {(polynomial / content).expand(), content};
}

LowestTerms lowest_terms(const ex& rational) {
  const SymbolRing symbols({rational});
  const PolynomialQuotient found = evaluate_rational(rational, QuotientAlgebra{symbols.ring(), {}});
  return {symbols.sum(found.over), symbols.sum(found.under)};
}

CommonFactor common_factor(const ex& a, const ex& b) {
  const SymbolRing ring({a, b});
  const WholePolynomial whole_a = whole_of(a), whole_b = whole_of(b);
  const SharedFactor shared =
      shared_factor(ring.polynomial(whole_a.whole), ring.polynomial(whole_b.whole));
  if (shared.factor.is_one()) return {1, a, b};
  return {ring.sum(shared.factor), (whole_a.number * ring.sum(shared.a_left)).expand(),
          (whole_b.number * ring.sum(shared.b_left)).expand()};
}

std::vector<ex> split_by(const ex& polynomial, const std::vector<ex>& symbols) {
  hear_interruption();
  std::vector<ex> all = symbols;
  all.push_back(polynomial);
  const SymbolRing ring(all);
  const WholePolynomial whole = whole_of(polynomial);
  Polynomial rest = ring.polynomial(whole.whole);
  const fmpz_mpoly_ctx_struct* context = rest.ring().context();
  std::vector<ex> factors;
  for (const ex& symbol : symbols) {
    slong index = static_cast<slong>(rest.ring().index(symbol_name(symbol)));
    if (has_lone_term(rest, static_cast<std::size_t>(index))) continue;
    Polynomial content(rest.ring(), 0);
    const int found = fmpz_mpoly_content_vars(content.raw(), rest.raw(), &index, 1, context);
    ensure(found != 0, "polynomials of this size have contents");
    if (content.is_number()) continue;
    fmpz_mpoly_divides(rest.raw(), rest.raw(), content.raw(), context);
    factors.push_back(ring.sum(content));
  }
  factors.push_back((whole.number * ring.sum(rest)).expand());
  return factors;
}

}  // namespace vcrit::symbolic
