// The two names that make steps, limits and conditions short: g = K_n/K_t and Z = k_d - m omega^2.
#pragma once

#include <ginac/ginac.h>

#include <optional>
#include <vector>

#include "derivation/derivation.hpp"
#include "formula/line.hpp"

namespace vcrit::symbolic {

struct Abbreviations {
  std::optional<Line> ratio;      ///< of an isotropic contact with a Poisson's ratio or a number
  std::optional<Line> stiffness;  ///< of a body under a drive with one spring from end to end

  /// Those that expressions have.
  std::vector<Line> used_by(const std::vector<GiNaC::ex>& expressions) const;
};

Abbreviations abbreviations(const Derivation& derivation);

}  // namespace vcrit::symbolic
