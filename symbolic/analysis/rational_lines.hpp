// v*^2 as a rational function of omega^2, and the equation for its extrema, as lines that people
// read: factored, and in Z = k_d - m omega^2 or beta = m omega^2/k_d where that is shorter.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/rational_form.hpp"
#include "formula/line.hpp"
#include "problem/problem.hpp"

namespace vcrit::symbolic {

/// The names of a mass and of the spring that carries it.
struct Swinging {
  std::string mass, spring;
};

/// Of a body under a drive with one spring from end to end.
std::optional<Swinging> swinging(const Problem& problem);

/// g = K_n/K_t of an isotropic contact: formulas in it are shorter than in nu, and 14 and 17 are
/// numbers without a meaning. Nothing for a ratio that has a name or is 1, and for one with a value
/// where no drive is beside the contact.
std::optional<Line> ratio_line(const Problem& problem);
/// The contact's ratio as 1/g, where g has a line.
Change in_ratio(const Problem& problem);

/// v*^2 = mu0^2 du_z^2 omega^2 N/D, N and D by powers of omega, and their coefficients.
std::vector<Line> lines_of(const RationalForm& form, const std::optional<Swinging>& swinging = {});

/// The equation for the frequencies besides 0 at which v* is largest or least; nothing where it has
/// no coefficient of another sign, so that v* has no such frequency. The form's symbols are
/// positive.
std::vector<Line> extrema_lines_of(const RationalForm& form,
                                   const std::optional<Swinging>& swinging = {});

/// A polynomial in the scene's symbols, omega and s.
GiNaC::ex expression(const Polynomial& polynomial);

}  // namespace vcrit::symbolic
