// GiNaC's polynomials as FLINT's and back. FLINT finds common factors in a small part of the time
// that GiNaC takes.
#pragma once

#include <ginac/ginac.h>

#include <cstddef>
#include <string>
#include <vector>

#include "network/polynomial.hpp"

namespace vcrit::symbolic {

/// The symbols of some expressions as variables, in the order of their names.
class SymbolRing {
 public:
  explicit SymbolRing(const std::vector<GiNaC::ex>& expressions);

  /// Of an expanded polynomial in these symbols with integer coefficients.
  Polynomial polynomial(const GiNaC::ex& expanded) const;
  GiNaC::ex sum(const Polynomial& polynomial) const;
  const Ring& ring() const { return ring_; }

 private:
  std::size_t index(const GiNaC::ex& symbol) const;

  std::vector<GiNaC::ex> symbols_;
  Ring ring_;
};

/// polynomial = number * whole, which has integer coefficients.
struct WholePolynomial {
  GiNaC::ex whole, number;
};
WholePolynomial whole_of(const GiNaC::ex& polynomial);

/// over/under, both multiplied out, with integer coefficients.
struct LowestTerms {
  GiNaC::ex over, under;
};
/// A rational function with rational coefficients as one fraction without common factors.
LowestTerms lowest_terms(const GiNaC::ex& rational);

/// a = common * a_left, b = common * b_left; all of them multiplied out.
struct CommonFactor {
  GiNaC::ex common, a_left, b_left;
};
/// Of two expanded polynomials with rational coefficients.
CommonFactor common_factor(const GiNaC::ex& a, const GiNaC::ex& b);

/// The factors of an expanded polynomial with rational coefficients, none of them a symbol, that
/// lack the first of these symbols, of what is left those that lack the second, ..., and at the end
/// what is left: their product is the polynomial.
std::vector<GiNaC::ex> split_by(const GiNaC::ex& polynomial, const std::vector<GiNaC::ex>& symbols);

}  // namespace vcrit::symbolic
