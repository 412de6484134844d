// That what is printed is the derived formula.
#pragma once

#include <ginac/ginac.h>

#include <functional>
#include <optional>
#include <vector>

#include "analysis/residues.hpp"
#include "derivation/derivation.hpp"
#include "derivation/model.hpp"
#include "formula/line.hpp"
#include "shortest/shortest.hpp"

namespace vcrit::symbolic {

/// Throws Bug unless both have the same square at points modulo 2^61 - 1. `groups`: what the form
/// is written in, in the scene's symbols.
void prove(const ShortestForm& form, const SymbolicModel& model,
           const std::vector<Line>& groups = {});

/// Likewise of a line v* = ... without names.
void prove(const GiNaC::ex& velocity, const SymbolicModel& model);

/// Likewise of v*^2, a rational function of the definitions, which may stand in any order.
void prove_square(const GiNaC::ex& square, const std::vector<Line>& definitions,
                  const SymbolicModel& model);

/// Throws Bug unless the square of the form, which need not be of v*, is that at points.
void prove_at_points(const ShortestForm& form,
                     const std::function<GaussianResidue(const ResiduePoint&)>& square);

/// The form that was found, proved.
FoundForm proved(FoundForm found, const Derivation& derivation,
                 const std::vector<Line>& groups = {});

/// The shortest form, as far as there is one, proved.
std::optional<ShortestForm> proved_shortest_form(const Derivation& derivation);

}  // namespace vcrit::symbolic
