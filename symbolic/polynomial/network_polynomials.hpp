// K(s) of a network multiplied out, by the shortest way: numerators and denominators of series and
// parallel parts are multiplied and added, with no common divisor taken out until the end; graphs
// through spanning trees, K = sum over spanning trees/sum over pairs of trees that part the
// terminals (Kirchhoff), as minors of the nodal matrix that are expanded without a division.
#pragma once

#include <ginac/ginac.h>

#include "network/network.hpp"
#include "network/polynomial.hpp"

namespace vcrit::symbolic {

/// How many terms K(s) has when multiplied out, known without doing it: exact where no element
/// occurs twice, else an upper bound.
struct TermNumbers {
  double over = 0, under = 0;
};
TermNumbers term_numbers(const Network& network);

/// The ring needs own_name("s") and the network's symbols. No factor is left that divides both.
PolynomialQuotient stiffness(const Network& network, const Ring& ring);

/// A whole number as a polynomial of the ring.
Polynomial integer_polynomial(const Ring& ring, const GiNaC::numeric& integer);

}  // namespace vcrit::symbolic
