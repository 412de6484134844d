// A stretch of motion over several events, recorded, with its derivative where that is asked for.
#pragma once

#include <vector>

#include "simulation/motion.hpp"

namespace vcrit::simulation {

struct Trace {
  struct Part {
    Piece piece;
    double duration;
  };
  std::vector<Part> parts;
  State end;
  double impulse = 0;  ///< time integral of F

  /// Derivatives of `end` (at fixed time) and of the impulse, by the columns of the start's
  /// changes.
  Matrix changes;
  Eigen::RowVectorXd impulse_changes;
};

/// The motion from `start` over `duration`. `changes`: of the start, at fixed time, or no columns.
/// Throws ModelError where events pile up without end.
Trace trace(const Model& model, double velocity, const State& start, double duration,
            const Matrix& changes);

/// The state right after the next event, or `horizon` later if there is none before.
State next_event_state(const Model& model, double velocity, const State& start, double horizon);

}  // namespace vcrit::simulation
