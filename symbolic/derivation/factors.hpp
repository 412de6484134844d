// A rational function kept as a product of polynomials, and its absolute value at s = i omega.
#pragma once

#include <ginac/ginac.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace vcrit::symbolic {

/// coefficient * monomial * product(over)/product(under). The polynomials have integer coefficients
/// without a common divisor, no symbol as a factor, a positive first term in the order of form.hpp,
/// and no common factor across the bar: up to the order of GiNaC's terms, one form for one function
/// and one way of building it.
class Factors {
 public:
  /// Multiplies by polynomial^exponent, exponent +1 or -1.
  void multiply(const GiNaC::ex& polynomial, int exponent);
  /// Multiplies by the numerator and divides by the denominator of a rational function.
  void multiply_rational(const GiNaC::ex& function);
  /// The same, each factor of a product by itself: what is a product below the bar stays one.
  void multiply_product(const GiNaC::ex& product);
  /// Removes common factors of the polynomials above and below the bar.
  void cancel();

  GiNaC::ex value() const;
  /// |value| at s = i omega, where all symbols are positive; quantities K_n, ... stay as |K_n|.
  GiNaC::ex modulus() const;
  /// The factors with their exponents, without the coefficient.
  std::vector<std::pair<GiNaC::ex, int>> parts() const;
  const GiNaC::numeric& coefficient() const { return coefficient_; }

 private:
  void put(GiNaC::ex polynomial, int exponent);

  GiNaC::numeric coefficient_ = 1;
  std::map<std::string, std::pair<GiNaC::ex, int>> monomial_;  ///< by name: symbol, exponent
  std::vector<GiNaC::ex> over_, under_;
};

/// A rational function as one fraction: numbers and monomials drawn out, common factors cancelled.
GiNaC::ex factored(const GiNaC::ex& rational);
/// A polynomial with its number and its monomial drawn out.
GiNaC::ex factored_polynomial(const GiNaC::ex& polynomial);

/// Whether an expression that keeps its sign for all values of its symbols is negative.
bool is_negative(const GiNaC::ex& expression);

/// Each absolute value in a formula as a polynomial in a letter: |K_n + g (K_d - m omega^2)|.
GiNaC::ex by_letter(const GiNaC::ex& formula, const GiNaC::ex& letter);

/// A polynomial f of s = i omega as even + i omega odd.
struct EvenOdd {
  GiNaC::ex even, odd;
};
EvenOdd even_odd(const GiNaC::ex& f);

}  // namespace vcrit::symbolic
