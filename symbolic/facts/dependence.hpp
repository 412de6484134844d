// Whether v* depends on a symbol, or on the frequency besides its factor omega.
#pragma once

#include <set>
#include <string>

#include "derivation/model.hpp"

namespace vcrit::symbolic {

/// Whether v* is the same for all values of these, together. Wrong with a chance below 1e-40: v* is
/// compared at three points modulo 2^61 - 1 (see chance_of_agreement).
bool is_independent_of(const SymbolicModel& model, const std::set<std::string>& names);

/// Whether v*/omega is the same at all frequencies.
bool is_proportional_to_frequency(const SymbolicModel& model);

}  // namespace vcrit::symbolic
