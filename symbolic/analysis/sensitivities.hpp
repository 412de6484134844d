// How v* depends on each of its parameters.
#pragma once

#include <ginac/ginac.h>

#include <vector>

#include "analysis/abbreviations.hpp"
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

/// Of all parameters of v*, in the order of Derivation::parameters.
struct Sensitivities {
  /// G_j = (dB/dK_j)/B with B the amplitude, v* = omega |B|: what all of `each` name, where the
  /// lines of each would be too long together. Those of later K_j come first.
  std::vector<Line> shared;
  std::vector<Sensitivity> each;
};

/// Sensitivities of up to a few dozen terms are multiplied out; larger ones follow the definitions
/// by the chain rule, forwards, in as many lines for each parameter as these have, or backwards, in
/// as many lines for all of them. Each `relative` is written in g and Z if all of them together are
/// shorter then.
Sensitivities sensitivities(const Derivation& derivation, const Abbreviations& names = {});

/// Characters of the definitions of v*, which its sensitivities take some times, backwards.
std::size_t length_of_definitions(const Derivation& derivation);

}  // namespace vcrit::symbolic
