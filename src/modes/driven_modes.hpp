// Modes of a linear motion that is pushed by what decays on its own:
//   y' = A y + direction p',   p = sum_i q_i,   q_i' = -a_i q_i.
// Where a rate of y and one of q are near each other, both are a pair of modes: convolutions of
// equal rates are as accurate as others.
#pragma once

#include "modes/spectrum.hpp"

namespace vcrit::simulation {

/// `own` are the modes of A. The result is on (y, q); it may have more modes than numbers, and
/// gives back y and q. rates > 0, all different. Throws ModelError where one is near both modes of
/// a pair.
Modes driven(const Modes& own, ConstView direction, const Vector& rates);

}  // namespace vcrit::simulation
