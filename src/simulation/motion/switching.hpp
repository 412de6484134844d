// What happens to the state where one motion changes into another: from slip to stick, from stick
// to slip of either direction, and, at times that the normal force gives, from any of them to
// separated and back.
#pragma once

#include "simulation/motion/piece.hpp"

namespace vcrit::simulation {

/// dx/dt of a state.
Vector rate_of(const Model& model, const State& state);

/// The state after the motion has changed to `to`.
State switched(const Model& model, const State& before, Motion to);

/// The state where the contact has opened, and where it has closed. A contact without a direct
/// damper closes without force, whatever F_n; with one the force jumps to what holds the contact
/// point, if the bound allows.
State after_opening(const Model& model, const State& before);
State after_closing(const Model& model, double velocity, const State& before);

/// Carries changes across opening or closing, at a time that none of them shifts.
void carry_over_opening(const Model& model, Matrix& changes);
void carry_over_closing(const Model& model, const State& after, Matrix& changes);

/// By how much each change of the state shifts the time of the event: -(change of its function)/
/// (slope of its function).
Vector event_shifts(const Model& model, const State& before, Motion to, double slope,
                    const Matrix& changes);

/// Carries changes across the switch: with the event's time goes the difference of the rates before
/// and after (saltation).
void carry_across(const Model& model, const State& before, const State& after, const Vector& shifts,
                  Matrix& changes);

}  // namespace vcrit::simulation
