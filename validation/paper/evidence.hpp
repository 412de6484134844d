// The full motion by three methods that share no code, beside 25 digits and the reduced model; and
// v* by simulation, for an isotropic contact whatever its damping, and under a drive with a body.
#pragma once

#include "paper/contents.hpp"

namespace vcrit::validation::paper {

Evidence hear_witnesses();

/// The row's three methods against its reference.
std::vector<Comparison> compare_witness(const Witness& witness);

}  // namespace vcrit::validation::paper
