// What happens to the state where one motion changes into another: always from slip to stick, or
// from stick to slip of either direction.
#pragma once

#include "simulation/motion/piece.hpp"

namespace vcrit::simulation {

/// dx/dt of a state.
Vector rate_of(const Model& model, const State& state);

/// The state after the motion has changed to `to`.
State switched(const Model& model, const State& before, Motion to);

/// By how much each change of the state shifts the time of the event: -(change of its function)/
/// (slope of its function).
Vector event_shifts(const Model& model, const State& before, Motion to, double slope,
                    const Matrix& changes);

/// Carries changes across the switch: with the event's time goes the difference of the rates before
/// and after (saltation).
void carry_across(const Model& model, const State& before, const State& after, const Vector& shifts,
                  Matrix& changes);

}  // namespace vcrit::simulation
