// v*^2 multiplied out: a rational function of omega^2 with integer coefficients, without common
// factors, so that it is the same for all ways to write one v*.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "derivation/model.hpp"
#include "network/polynomial.hpp"
#include "problem/problem.hpp"

namespace vcrit::symbolic {

/// v*^2 = (mu0 du_z)^2 over/under; the polynomials are in omega and the scene's symbols, omega in
/// even powers only.
struct RationalForm {
  std::shared_ptr<const Ring> ring;
  PolynomialQuotient square;
};

/// How many terms the polynomials of v* have at most before they are squared.
double terms_before_squaring(const SymbolicModel& model);

/// B/(mu0 du_z), a rational function of s and of the scene's symbols.
struct Amplitude {
  std::shared_ptr<const Ring> ring;
  PolynomialQuotient per_friction;  ///< without common factors
};

/// Throws ModelError, naming both numbers, if terms_before_squaring is more than `budget`. The
/// contact's ratio is that of the change, where it has one.
Amplitude multiplied_out(const SymbolicModel& model, double budget, const Change& change = {});
/// Likewise.
RationalForm rational_form(const SymbolicModel& model, double budget, const Change& change = {});

/// The same with values for all symbols but omega; of any size.
RationalForm rational_form(const SymbolicModel& model,
                           const std::map<std::string, GiNaC::numeric>& values);

/// The same text for the same function.
std::string canonical_text(const RationalForm& form);

/// What the equation for extrema costs: the products of its derivative. Its greatest common divisor
/// costs some hundred times that.
std::size_t products_of_extrema(const RationalForm& form);
/// What takes less than a second.
inline constexpr std::size_t most_products_of_extrema = 20'000;

/// The polynomial in omega^2, and in the symbols, that is 0 at the frequencies of largest and least
/// v* besides 0: the numerator of d(v*^2)/d(omega), without factors that omega does not occur in.
/// The form's ring is the polynomial's.
Polynomial stationary(const RationalForm& form);
Polynomial stationary(RationalForm&& form) = delete;

}  // namespace vcrit::symbolic
