// Rational functions as fractions of FLINT's polynomials, for evaluate_rational.
#pragma once

#include <ginac/ginac.h>

#include <map>
#include <string>

#include "network/polynomial.hpp"
#include "polynomial/network_polynomials.hpp"

namespace vcrit::symbolic {

/// Of values without common factors it makes values without common factors.
struct QuotientAlgebra {
  using Value = PolynomialQuotient;
  const Ring& ring;
  std::map<std::string, PolynomialQuotient> known;  ///< what is not a variable of the ring

  Value number(const GiNaC::numeric& value) const {
    return {integer_polynomial(ring, value.numer()), integer_polynomial(ring, value.denom())};
  }
  Value name(const std::string& name) const {
    const auto found = known.find(name);
    if (found != known.end()) return found->second;
    return {Polynomial::variable(ring, name), Polynomial(ring, 1)};
  }
  Value add(const Value& a, const Value& b) const { return cancelled(a + b); }
  // Of two fractions without common factors only those across the bar may have some.
  Value multiply(const Value& a, const Value& b) const {
    return cancelled({a.over, b.under}) * cancelled({b.over, a.under});
  }
  Value invert(const Value& a) const { return turned_over(a); }
};

}  // namespace vcrit::symbolic
