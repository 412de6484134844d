// That a shortest form is the derived formula.
#pragma once

#include <optional>

#include "derivation/derivation.hpp"
#include "derivation/model.hpp"
#include "shortest/shortest.hpp"

namespace vcrit::symbolic {

/// Throws Bug unless both have the same square at points modulo 2^61 - 1.
void prove(const ShortestForm& form, const Model& model);

/// The shortest form, as far as there is one, proved.
std::optional<ShortestForm> proved_shortest_form(const Derivation& derivation);

}  // namespace vcrit::symbolic
