// Formulas as C++ functions, the way one types them in: every operation as it stands in the text.
#pragma once

#include <string>

#include "derivation/derivation.hpp"
#include "emit/parameters.hpp"

namespace vcrit::validation {

/// "static double NAME(const Parameters& p) {...}" of the derivation's v*, with complex numbers
/// where it is nested. Needs what pasted_preamble() defines.
std::string pasted_function(const std::string& name, const symbolic::Derivation& derivation,
                            const symbolic::ParameterList& parameters);

/// With the table of a measured drive.
std::string pasted_preamble(const Problem& problem);

}  // namespace vcrit::validation
