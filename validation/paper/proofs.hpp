// (29) to (31) derived from scenes and proved equal to what the paper prints, and the constant that
// is left of any rheology under a rigid drive.
#pragma once

#include "paper/contents.hpp"

namespace vcrit::validation::paper {

Proofs prove_equations();

}  // namespace vcrit::validation::paper
