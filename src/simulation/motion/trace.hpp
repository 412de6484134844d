// A stretch of motion over several events, recorded, with its derivative where that is asked for.
#pragma once

#include <vector>

#include "simulation/motion/piece.hpp"

namespace vcrit::simulation {

struct Trace {
  struct Part {
    Piece piece;
    double duration;
  };
  std::vector<Part> parts;
  State end;
  Vector integrals;  ///< time integrals of the levels F, u, g_j

  /// Derivatives of `end` (at fixed time) and of the integrals, by the columns of the start's
  /// changes.
  Matrix changes;
  Matrix integral_changes;

  double impulse() const { return integrals(0); }
};

/// The motion from `start` over `duration`. `changes`: of the start, at fixed time, or no columns.
/// Throws ModelError where events pile up without end.
Trace trace(const Model& model, double velocity, const State& start, double duration,
            const Matrix& changes);

/// The state right after the next event, or `horizon` later if there is none before.
State next_event_state(const Model& model, double velocity, const State& start, double horizon);

}  // namespace vcrit::simulation
