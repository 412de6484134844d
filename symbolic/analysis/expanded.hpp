// v* multiplied out.
#pragma once

#include "derivation/derivation.hpp"

namespace vcrit::symbolic {

/// The derivation with its formula multiplied out, factors of polynomials apart. Throws ModelError,
/// naming both numbers, where the polynomials have more terms than `budget`, and where v* is no
/// quotient of polynomials.
Derivation expanded_form(Derivation derivation, double budget);

}  // namespace vcrit::symbolic
