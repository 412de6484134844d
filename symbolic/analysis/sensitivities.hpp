// How v* depends on each of its parameters.
#pragma once

#include <ginac/ginac.h>

#include <vector>

#include "derivation/derivation.hpp"
#include "formula/line.hpp"

namespace vcrit::symbolic {

struct Sensitivity {
  Symbol parameter;
  Expression relative;    ///< S_p = (p/v*) dv*/dp
  Expression derivative;  ///< dv*/dp = v* S_p/p
  /// What `relative` names, where it is not multiplied out: K_1, ..., K_n as in Derivation, and
  /// dK_1, ..., dK_n with dK_j = p dK_j/dp. What `derivative` names besides is v*'s.
  std::vector<Line> stiffnesses, changes;
};

/// For every parameter of v*, in the order of Derivation::parameters. Sensitivities of up to a few
/// dozen terms are multiplied out; larger ones follow the definitions by the chain rule, in as many
/// lines as these have.
std::vector<Sensitivity> sensitivities(const Derivation& derivation);

}  // namespace vcrit::symbolic
