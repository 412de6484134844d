// v*^2 multiplied out: a rational function of omega^2 with integer coefficients, without common
// factors, so that it is the same for all ways to write one v*.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "derivation/model.hpp"
#include "formula/line.hpp"
#include "polynomial/polynomial.hpp"
#include "problem/problem.hpp"

namespace vcrit::symbolic {

/// v*^2 = (mu0 du_z)^2 over/under; the polynomials are in omega and the scene's symbols, omega in
/// even powers only.
struct RationalForm {
  std::shared_ptr<const Ring> ring;
  Quotient square;
};

/// How many terms the polynomials of v* have at most before they are squared.
double terms_before_squaring(const Model& model);

/// Throws ModelError, naming both numbers, if terms_before_squaring is more than `budget`.
RationalForm rational_form(const Model& model, double budget);

/// The same with values for all symbols but omega; of any size.
RationalForm rational_form(const Model& model, const std::map<std::string, GiNaC::numeric>& values);

/// The same text for the same function.
std::string canonical_text(const RationalForm& form);

/// Whether the equation for extrema takes less than a second.
bool has_readable_extrema(const RationalForm& form);

/// The polynomial in omega^2, and in the symbols, that is 0 at the frequencies of largest and least
/// v* besides 0: the numerator of d(v*^2)/d(omega), without factors that omega does not occur in.
/// The form's ring is the polynomial's.
Polynomial stationary(const RationalForm& form);
Polynomial stationary(RationalForm&& form) = delete;

/// A polynomial as a line by powers of omega, name = coefficient_0 + coefficient_2 omega^2 + ...,
/// with its words, and a line for each coefficient of several terms.
std::vector<Line> lines_by_omega(const Polynomial& polynomial, const std::string& name,
                                 const std::string& coefficient, const std::string& words);

/// The form as lines of mathematics: v*^2 = mu0^2 du_z^2 omega^2 N/D, N and D by powers of omega,
/// and their coefficients.
std::vector<Line> lines_of(const RationalForm& form);

}  // namespace vcrit::symbolic
