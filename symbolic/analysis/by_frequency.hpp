// Polynomials as people write them: by powers of omega, k1^2 (k0 + g Z) + c1^2 omega^2 (k0 + k1 + g
// Z).
#pragma once

#include <ginac/ginac.h>

namespace vcrit::symbolic {

/// A polynomial by powers of omega, its coefficients as products, if it is shorter then; else as it
/// is.
GiNaC::ex by_frequency(const GiNaC::ex& polynomial);

/// Each sum of a product of powers likewise.
GiNaC::ex factors_by_frequency(const GiNaC::ex& product);

}  // namespace vcrit::symbolic
