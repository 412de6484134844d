#include "network/rational.hpp"

#include <flint/fmpq.h>
#include <flint/fmpz_poly.h>

#include <algorithm>
#include <cstdlib>

namespace vcrit {

namespace {

/// Where the digits end and the power of ten begins, and that power.
struct DigitsAndExponent {
  std::string digits;
  long exponent = 0;
};

DigitsAndExponent digits_and_exponent(const std::string& text) {
  DigitsAndExponent found;
  const std::size_t mark = text.find_first_of("eE");
  if (mark != text.npos) found.exponent = std::strtol(text.c_str() + mark + 1, nullptr, 10);
  found.digits = text.substr(0, mark);
  const std::size_t point = found.digits.find('.');
  if (point == found.digits.npos) return found;
  found.exponent -= static_cast<long>(found.digits.size() - point - 1);
  found.digits.erase(point, 1);
  return found;
}

}  // namespace

ExactPolynomial::ExactPolynomial(const std::string& decimal) : ExactPolynomial() {
  const DigitsAndExponent number = digits_and_exponent(decimal);
  fmpz_t digits, power;
  fmpq_t whole;
  fmpz_init(digits);
  fmpz_init(power);
  fmpq_init(whole);
  fmpz_set_str(digits, number.digits.c_str(), 10);
  fmpz_set_ui(power, 10);
  fmpz_pow_ui(power, power, static_cast<ulong>(std::labs(number.exponent)));
  fmpq_set_fmpz(whole, digits);
  if (number.exponent < 0)
    fmpq_div_fmpz(whole, whole, power);
  else
    fmpq_mul_fmpz(whole, whole, power);
  fmpq_poly_set_fmpq(value_, whole);
  fmpq_clear(whole);
  fmpz_clear(power);
  fmpz_clear(digits);
}

ExactPolynomial ExactPolynomial::variable() {
  ExactPolynomial s;
  fmpq_poly_set_coeff_si(s.value_, 1, 1);
  return s;
}

long ExactPolynomial::bits() const {
  const long above = std::labs(_fmpz_vec_max_bits(value_->coeffs, value_->length));
  return std::max(above, static_cast<long>(fmpz_bits(value_->den)));
}

std::pair<std::string, std::string> ExactPolynomial::fraction() const {
  const auto text = [](const fmpz_t integer) {
    char* const digits = fmpz_get_str(nullptr, 10, integer);
    std::string copy(digits);
    flint_free(digits);
    return copy;
  };
  return {is_zero() ? "0" : text(value_->coeffs), text(value_->den)};
}

ExactPolynomial ExactPolynomial::operator-() const {
  ExactPolynomial negative;
  fmpq_poly_neg(negative.value_, value_);
  return negative;
}

ExactPolynomial operator+(const ExactPolynomial& a, const ExactPolynomial& b) {
  ExactPolynomial sum;
  fmpq_poly_add(sum.value_, a.value_, b.value_);
  return sum;
}

ExactPolynomial operator*(const ExactPolynomial& a, const ExactPolynomial& b) {
  ExactPolynomial product;
  fmpq_poly_mul(product.value_, a.value_, b.value_);
  return product;
}

RationalFunction RationalFunction::reduced() const {
  ExactPolynomial common;
  fmpq_poly_gcd(common.raw(), above.raw(), below.raw());
  RationalFunction reduced;
  fmpq_poly_div(reduced.above.raw(), above.raw(), common.raw());
  fmpq_poly_div(reduced.below.raw(), below.raw(), common.raw());
  return reduced;
}

}  // namespace vcrit
