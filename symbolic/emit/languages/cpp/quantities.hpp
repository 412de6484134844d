// What a generated header of quantities has as its parameters.
#pragma once

#include "emit/parameters.hpp"

namespace vcrit::symbolic {

/// The members of QuantityParameters: mu0, omega, du_z and every symbol of the scene that one of
/// the quantities depends on, whether v* does or not.
ParameterList quantity_parameters(const Problem& problem, const FixedValues& fixed = {});

}  // namespace vcrit::symbolic
