// The symbols of a derivation in GiNaC: one object for one name in the whole program, so that
// expressions of different calls can be compared, and exact numbers.
#pragma once

#include <ginac/ginac.h>

#include <string>

#include "network/network.hpp"

namespace vcrit::symbolic {

/// The positive real symbol of an element or a quantity of the scene.
GiNaC::ex symbol(const Symbol& symbol);

/// The symbol of a Poisson's ratio: real, between -1 and 1/2.
GiNaC::ex poisson_ratio(const Symbol& symbol);

/// A complex quantity of the derivation itself: K_n, K_t, K_d, the amplitudes A and B, s, ...
GiNaC::ex quantity(const std::string& name);

/// A positive quantity of the derivation itself: a dimensionless group.
GiNaC::ex positive_quantity(const std::string& name);

/// A real quantity of the derivation itself, of either sign: Z = k_d - m omega^2.
GiNaC::ex real_quantity(const std::string& name);

/// omega, and s = i omega.
GiNaC::ex omega();
GiNaC::ex laplace();

/// The decimal that reads back to `value`, as an exact fraction: 0.3 is 3/10.
GiNaC::numeric exact_decimal(double value);
/// The same of a decimal as it is written, "0.3" or "3e-1".
GiNaC::numeric exact_decimal(const std::string& text);

/// The fraction that the double itself is.
GiNaC::numeric exact_binary(double value);

}  // namespace vcrit::symbolic
