// The limits and special cases of v* that a scene has.
#pragma once

#include <ginac/ginac.h>

#include <string>
#include <vector>

#include "analysis/abbreviations.hpp"
#include "derivation/derivation.hpp"
#include "derivation/stiffness_forms.hpp"
#include "formula/line.hpp"
#include "formula/prose.hpp"

namespace vcrit::symbolic {

/// A limit or special case of v* that applies to the scene.
struct Limit {
  std::string name;      ///< "kd -> infinity", say
  Prose title;           ///< the same
  std::string equation;  ///< number in the paper, "(31)", where it is one, else empty
  Expression result;
  Expression shown;               ///< the same, in g and Z where these make it shorter
  std::vector<Line> definitions;  ///< as in Derivation
  GrowthExponents rates;          ///< a way to approach it; empty where values alone do not
};

/// Drive to rigid, mass to 0, each element (an array as one) to 0 and to infinity, all dampers to
/// 0, then the drive to rigid, and the isotropic contact where both networks have one shape. Left
/// out: limits that cut a network in two, in which the normal force grows without end or its mean
/// can no longer be carried, or in which nothing is left that moves.
std::vector<Limit> limits(const Derivation& derivation, const Abbreviations& names = {});

}  // namespace vcrit::symbolic
