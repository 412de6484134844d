// The logarithmic derivative of a product of powers.
#pragma once

#include <ginac/ginac.h>

#include <optional>

namespace vcrit::symbolic {

/// (x/f) df/dx of a positive product of powers, roots and absolute values of real polynomials: as
/// one fraction, or as a sum of one for each factor where that is much shorter; nothing if that is
/// too long to read.
std::optional<GiNaC::ex> logarithmic_derivative(const GiNaC::ex& f, const GiNaC::ex& x);

}  // namespace vcrit::symbolic
