// What happens to the state where one motion changes into another: always from slip to stick, or
// from stick to slip of either direction.
#pragma once

#include "simulation/motion/piece.hpp"

namespace vcrit::simulation {

/// dx/dt of a state.
Vector rate_of(const Model& model, const State& state);

/// The state after the motion has changed to `to`.
State switched(const Model& model, const State& before, Motion to);

/// Changes dx at fixed time carried across that switch, column by column: the event moves by
/// dt = -(change of its function)/(rate of its function), and with it goes the difference of the
/// rates before and after (saltation).
Matrix switched_changes(const Model& model, const State& before, const State& after,
                        const Matrix& dx);

}  // namespace vcrit::simulation
