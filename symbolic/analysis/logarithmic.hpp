// The logarithmic derivative of a product of powers.
#pragma once

#include <ginac/ginac.h>

#include <optional>
#include <vector>

#include "formula/line.hpp"

namespace vcrit::symbolic {

/// (x/f) df/dx of a positive product of powers, roots and absolute values of real polynomials: as
/// one fraction, or as a sum of one for each factor where that is much shorter; nothing if that is
/// too long to read. f may be written in letters, polynomials that change with x.
std::optional<GiNaC::ex> logarithmic_derivative(const GiNaC::ex& f, const GiNaC::ex& x,
                                                const std::vector<Line>& letters = {});

}  // namespace vcrit::symbolic
