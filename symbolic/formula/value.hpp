// Values of formulas.
#pragma once

#include <ginac/ginac.h>

#include <map>
#include <vector>

#include "formula/line.hpp"
#include "network/network.hpp"

namespace vcrit::symbolic {

/// A formula's value; `values` holds every parameter, and `definitions` what the formula names
/// besides them, in order. Carries the digits of GiNaC::Digits.
GiNaC::numeric value_at(const GiNaC::ex& formula, const std::vector<Line>& definitions,
                        const std::map<Symbol, GiNaC::numeric>& values);

}  // namespace vcrit::symbolic
