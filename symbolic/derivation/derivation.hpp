// Eq. 24 derived for a scene: the harmonic balance of contact point (19) and body (13) is set up
// and solved by GiNaC, the scene's networks are put in, and the result is brought to one form that
// does not depend on the run.
#pragma once

#include <ginac/ginac.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "formula/line.hpp"
#include "problem/problem.hpp"

namespace vcrit::symbolic {

class SymbolicModel;

/// Handed on to all who ask something of the formula: nothing is derived twice.
struct Derivation {
  Problem problem;  ///< whose formula it is
  std::shared_ptr<const SymbolicModel>
      model;                       ///< the scene prepared: what limits and the like start from
  std::vector<Line> lines;         ///< from the equations of motion to the result
  Expression critical_velocity;    ///< v*, real, in the scene's symbols (and in definitions, and in
                                   ///< R_d, the complex receptance of a measured drive)
  std::vector<Line> definitions;   ///< names in critical_velocity where it is too large to be
                                   ///< multiplied out: K_1, ..., K_n, as functions of s, in order
  std::string equation;            ///< number in the paper: "(24)", or of a special case
  std::vector<Symbol> parameters;  ///< the symbols v* depends on
};

/// A formula of up to about two dozen terms in each polynomial is multiplied out; a larger one
/// stays nested, in terms of K_n, K_t, K_d and further inner quantities.
Derivation derive(const Problem& problem);

/// The same with its formula nested, however small it is.
Derivation nested_form(Derivation derivation);

/// How many this process has made. Tests hold commands to one.
std::size_t derivations_made();

}  // namespace vcrit::symbolic
