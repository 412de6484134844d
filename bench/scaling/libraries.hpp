// GiNaC and FLINT as one would use them without thought for networks.
#pragma once

#include "scaling/peers.hpp"

namespace vcrit::scaling {

/// Sums, and series as 1/(1/a + 1/b); graphs are not of this kind.
std::optional<double> ginac_composed(const ScalingCase& each);
/// Balance at every node by lsolve, then normal.
std::optional<double> ginac_lsolve(const ScalingCase& each);
/// Two determinants of the nodal matrix.
std::optional<double> ginac_determinant(const ScalingCase& each);
/// Numerators and denominators of fmpz_mpoly by hand; not for graphs.
std::optional<double> flint_by_hand(const ScalingCase& each);

}  // namespace vcrit::scaling
