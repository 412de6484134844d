// Modes of a body held by a spring-damper network in relaxation form,
//   m a' = -c a - sum_j h_j,   h_j' = k_j a - a_j h_j,   y = (a, h_1, ..., h_n),
// from the roots of chi(s) = m s + c + sum_j k_j/(s + a_j). All roots but two are real and lie
// between the poles; the two are a complex pair or real. They come from secular equations, never
// from a numeric eigensolver: rates over twenty decades keep their relative accuracy.
#pragma once

#include "modes/spectrum.hpp"
#include "stiffness/relaxation.hpp"

namespace vcrit::simulation {

/// holder: K(s)/s of the network, see relaxation.hpp. mass > 0.
Modes body_modes(double mass, const PoleSum& holder);

}  // namespace vcrit::simulation
