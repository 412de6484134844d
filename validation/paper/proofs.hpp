// (27) and (29) to (31) derived from scenes and proved equal to the formulas typed in, and the
// constant that is left of any rheology under a rigid drive.
#pragma once

#include <ginac/ginac.h>

#include "paper/contents.hpp"

namespace vcrit::validation::paper {

Proofs prove_equations();

/// Whether two formulas of v*, both positive, are one function.
bool equal_velocities(const GiNaC::ex& a, const GiNaC::ex& b);

}  // namespace vcrit::validation::paper
