// SymPy and Maxima, each in a process of its own that times itself; absent where not installed.
#pragma once

#include "scaling/peers.hpp"

namespace vcrit::scaling {

/// Sums, and series as 1/(1/a + 1/b).
std::optional<double> sympy_composed(const ScalingCase& each);
/// The same in SymPy's field of fractions, which keeps everything multiplied out.
std::optional<double> sympy_field(const ScalingCase& each);
/// The composition, then cancel.
std::optional<double> sympy_cancel(const ScalingCase& each);
/// Two determinants of the nodal matrix by newdet.
std::optional<double> maxima_newdet(const ScalingCase& each);

}  // namespace vcrit::scaling
