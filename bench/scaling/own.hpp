// vcrit's own ways to K(s).
#pragma once

#include "scaling/peers.hpp"

namespace vcrit::scaling {

/// The reduction alone, in numbers of steps; with symbols, written as named lines; multiplied out.
std::optional<double> straight_line(const ScalingCase& each);
std::optional<double> named_formula(const ScalingCase& each);
std::optional<double> multiplied_out(const ScalingCase& each);

}  // namespace vcrit::scaling
