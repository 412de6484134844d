// That a shortest form is the derived formula.
#pragma once

#include "derivation/model.hpp"
#include "shortest/shortest.hpp"

namespace vcrit::symbolic {

/// Throws Bug unless both have the same square at points modulo 2^61 - 1.
void prove(const ShortestForm& form, const Model& model);

}  // namespace vcrit::symbolic
