#include "network/polynomial.hpp"

#include <flint/fmpz_mpoly_factor.h>

#include <algorithm>

#include "base/errors.hpp"
#include "base/interruption.hpp"

namespace vcrit {

Ring::Ring(const std::vector<std::string>& names) : names_(names) {
  for (std::size_t i = 0; i < names_.size(); ++i) index_.emplace(names_[i], i);
  fmpz_mpoly_ctx_init(context_, static_cast<slong>(names_.size()), ORD_LEX);
}

Ring::~Ring() { fmpz_mpoly_ctx_clear(context_); }

std::size_t Ring::index(const std::string& name) const {
  const auto found = index_.find(name);
  ensure(found != index_.end(), "a ring has the variables of its polynomials");
  return found->second;
}

Polynomial::Polynomial(const Ring& ring, long constant) : ring_(&ring) {
  fmpz_mpoly_init(value_, ring.context());
  fmpz_mpoly_set_si(value_, constant, ring.context());
}

Polynomial Polynomial::variable(const Ring& ring, const std::string& name) {
  Polynomial result(ring, 0);
  fmpz_mpoly_gen(result.value_, static_cast<slong>(ring.index(name)), ring.context());
  return result;
}

Polynomial Polynomial::power(const Ring& ring, const std::string& name, unsigned long exponent) {
  std::vector<unsigned long> exponents(ring.size());
  exponents[ring.index(name)] = exponent;
  Polynomial result(ring, 0);
  result.add_term("1", exponents);
  return result;
}

Polynomial::Polynomial(const Polynomial& other) : ring_(other.ring_) {
  fmpz_mpoly_init(value_, ring_->context());
  fmpz_mpoly_set(value_, other.value_, ring_->context());
}

Polynomial::Polynomial(Polynomial&& other) noexcept : ring_(other.ring_) {
  fmpz_mpoly_init(value_, ring_->context());
  fmpz_mpoly_swap(value_, other.value_, ring_->context());
}

Polynomial& Polynomial::operator=(Polynomial other) noexcept {
  std::swap(ring_, other.ring_);
  std::swap(*value_, *other.value_);
  return *this;
}

Polynomial::~Polynomial() { fmpz_mpoly_clear(value_, ring_->context()); }

bool Polynomial::is_zero() const { return fmpz_mpoly_is_zero(value_, ring_->context()) != 0; }
bool Polynomial::is_one() const { return fmpz_mpoly_is_one(value_, ring_->context()) != 0; }
bool Polynomial::is_number() const { return fmpz_mpoly_is_fmpz(value_, ring_->context()) != 0; }

std::size_t Polynomial::terms() const {
  return static_cast<std::size_t>(fmpz_mpoly_length(value_, ring_->context()));
}

std::vector<unsigned long> Polynomial::exponents(std::size_t i) const {
  std::vector<unsigned long> result(ring_->size());
  fmpz_mpoly_get_term_exp_ui(result.data(), value_, static_cast<slong>(i), ring_->context());
  return result;
}

std::string Polynomial::coefficient(std::size_t i) const {
  fmpz_t value;
  fmpz_init(value);
  fmpz_mpoly_get_term_coeff_fmpz(value, value_, static_cast<slong>(i), ring_->context());
  std::string text(fmpz_sizeinbase(value, 10) + 2, '\0');
  fmpz_get_str(text.data(), 10, value);
  fmpz_clear(value);
  text.resize(text.find('\0'));
  return text;
}

unsigned long Polynomial::degree(const std::string& variable) const {
  const auto index = static_cast<slong>(ring_->index(variable));
  return static_cast<unsigned long>(
      std::max(0L, fmpz_mpoly_degree_si(value_, index, ring_->context())));
}

Polynomial Polynomial::derivative(const std::string& variable) const {
  Polynomial result(*ring_, 0);
  fmpz_mpoly_derivative(result.value_, value_, static_cast<slong>(ring_->index(variable)),
                        ring_->context());
  return result;
}

unsigned long Polynomial::lowest_degree(const std::string& variable) const {
  const std::size_t index = ring_->index(variable);
  unsigned long lowest = is_zero() ? 0 : exponents(0)[index];
  for (std::size_t i = 1; i < terms(); ++i) lowest = std::min(lowest, exponents(i)[index]);
  return lowest;
}

Polynomial Polynomial::without_power(const std::string& variable, unsigned long power) const {
  Polynomial result(*ring_, 1), divisor = Polynomial::power(*ring_, variable, power);
  const int exact = fmpz_mpoly_divides(result.value_, value_, divisor.value_, ring_->context());
  ensure(exact != 0, "every term has the power of the variable");
  return result;
}

Polynomial Polynomial::primitive(const std::string& variable) const {
  if (is_zero()) return *this;
  Polynomial content(*ring_, 0), result(*ring_, 0);
  slong index = static_cast<slong>(ring_->index(variable));
  const int found = fmpz_mpoly_content_vars(content.value_, value_, &index, 1, ring_->context());
  ensure(found != 0 &&
             fmpz_mpoly_divides(result.value_, value_, content.value_, ring_->context()) != 0,
         "a content divides its polynomial");
  if (result.coefficient(0).starts_with('-'))
    fmpz_mpoly_neg(result.value_, result.value_, ring_->context());
  return result;
}

Polynomial& Polynomial::operator+=(const Polynomial& other) {
  fmpz_mpoly_add(value_, value_, other.value_, ring_->context());
  return *this;
}

Polynomial& Polynomial::operator-=(const Polynomial& other) {
  fmpz_mpoly_sub(value_, value_, other.value_, ring_->context());
  return *this;
}

Polynomial& Polynomial::operator*=(const Polynomial& other) {
  hear_interruption();
  fmpz_mpoly_mul(value_, value_, other.value_, ring_->context());
  return *this;
}

void Polynomial::add_term(const std::string& coefficient,
                          const std::vector<unsigned long>& exponents) {
  fmpz_t value, known;
  fmpz_init(value);
  fmpz_init(known);
  ensure(fmpz_set_str(value, coefficient.c_str(), 10) == 0, "coefficients are integers");
  fmpz_mpoly_get_coeff_fmpz_ui(known, value_, exponents.data(), ring_->context());
  fmpz_add(value, value, known);
  fmpz_mpoly_set_coeff_fmpz_ui(value_, value, exponents.data(), ring_->context());
  fmpz_clear(known);
  fmpz_clear(value);
}

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  hear_interruption();
  Polynomial result(a.ring(), 0);
  fmpz_mpoly_mul(result.value_, a.value_, b.value_, a.ring().context());
  return result;
}

bool operator==(const Polynomial& a, const Polynomial& b) {
  return fmpz_mpoly_equal(a.value_, b.value_, a.ring().context()) != 0;
}

FactoredPolynomial polynomial_factors(const Polynomial& polynomial) {
  hear_interruption();
  const fmpz_mpoly_ctx_struct* context = polynomial.ring().context();
  fmpz_mpoly_factor_t found;
  fmpz_mpoly_factor_init(found, context);
  const bool done = fmpz_mpoly_factor(found, polynomial.raw(), context) != 0;
  FactoredPolynomial result;
  if (done) {
    char* digits = fmpz_get_str(nullptr, 10, found->constant);
    result.constant = digits;
    flint_free(digits);
    for (slong i = 0; i < found->num; ++i) {
      Polynomial factor(polynomial.ring(), 0);
      fmpz_mpoly_set(factor.raw(), found->poly + i, context);
      result.factors.emplace_back(std::move(factor), fmpz_get_ui(found->exp + i));
    }
  }
  fmpz_mpoly_factor_clear(found, context);
  ensure(done, "polynomials of this size have factors");
  return result;
}

SharedFactor shared_factor(const Polynomial& a, const Polynomial& b) {
  hear_interruption();
  const Polynomial none(a.ring(), 0);
  SharedFactor shared{none, none, none};
  const int done =
      fmpz_mpoly_gcd_cofactors(shared.factor.raw(), shared.a_left.raw(), shared.b_left.raw(),
                               a.raw(), b.raw(), a.ring().context());
  ensure(done != 0, "polynomials of this size have a greatest common divisor");
  return shared;
}

PolynomialQuotient cancelled(const PolynomialQuotient& quotient) {
  if (quotient.under.is_one()) return quotient;
  const fmpz_mpoly_ctx_struct* context = quotient.over.ring().context();
  SharedFactor shared = shared_factor(quotient.over, quotient.under);
  PolynomialQuotient result{std::move(shared.a_left), std::move(shared.b_left)};
  if (result.under.coefficient(0).starts_with('-')) {
    fmpz_mpoly_neg(result.over.raw(), result.over.raw(), context);
    fmpz_mpoly_neg(result.under.raw(), result.under.raw(), context);
  }
  return result;
}

PolynomialQuotient operator+(const PolynomialQuotient& a, const PolynomialQuotient& b) {
  if (a.under == b.under) return {a.over + b.over, a.under};
  return {a.over * b.under + b.over * a.under, a.under * b.under};
}

PolynomialQuotient operator*(const PolynomialQuotient& a, const PolynomialQuotient& b) {
  return {a.over * b.over, a.under * b.under};
}

PolynomialQuotient turned_over(const PolynomialQuotient& a) { return {a.under, a.over}; }

}  // namespace vcrit
