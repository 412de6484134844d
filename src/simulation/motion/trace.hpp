// A stretch of motion over several events, recorded, with its derivative where that is asked for.
#pragma once

#include "simulation/motion/piece.hpp"

namespace vcrit::simulation {

/// Where a stretch of motion ends, and the time integrals over it (see model.hpp), with the changes
/// of both by those of its start.
struct Passage {
  State end;
  Vector integrals;
  Changes changes;

  double impulse() const { return integrals[0]; }
};

struct Trace : Passage {
  struct Part {
    Part(const Model& model, double velocity, const State& start) : piece(model, velocity, start) {}

    Piece piece;
    double duration = 0;
  };
  List<Part, 8> parts;
  double unlawful = 0;  ///< time passed in motions outside their law, where rounding left no other
};

/// Many times what a period of any sensible motion has.
inline constexpr std::size_t most_parts = 20'000;

/// The motion from `start` over `duration`. `changes`: of the start, at fixed time, or no columns.
/// Throws ModelError where it would take more parts, or has no time left in rounding.
Trace trace(const Model& model, double velocity, const State& start, double duration,
            const Matrix& changes = {}, std::size_t parts = most_parts);

/// The state right after the next event, or `horizon` later if there is none before.
State next_event_state(const Model& model, double velocity, const State& start, double horizon);

/// One column for each number of the state but F, which slip prescribes.
Matrix unit_changes(const State& slip, Index columns);

}  // namespace vcrit::simulation
