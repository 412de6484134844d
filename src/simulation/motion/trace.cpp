#include "simulation/motion/trace.hpp"

#include <algorithm>

#include "base/errors.hpp"
#include "simulation/motion/switching.hpp"

namespace vcrit::simulation {

namespace {

// Many times what a period of any sensible motion has.
constexpr std::size_t most_parts = 100'000;

// Two events in a row without time between them are one touch within rounding: the motion goes on
// without them for this share of a period, over which nothing can be gained or lost.
constexpr double touch = 1e-9;

}  // namespace

Trace trace(const Model& model, double velocity, const State& start, double duration,
            const Matrix& changes) {
  const Index levels = model.level_states();
  Trace result{{}, start, Vector::Zero(levels), changes, Matrix::Zero(levels, changes.cols())};
  const double end = start.time + duration;
  bool stood = false;
  while (result.end.time < end) {
    if (result.parts.size() == most_parts)
      throw ModelError("stick and slip alternate without end within one period");
    const Piece piece(model, velocity, result.end);
    double length = end - result.end.time;
    auto event = piece.next_event(length);
    if (event && event->duration == 0 && stood) {
      event.reset();
      length = std::min(length, touch);
    }
    if (event) length = event->duration;
    stood = length == 0;
    result.parts.push_back({piece, length});
    result.integrals += piece.integrals(length);
    if (changes.cols() > 0)
      result.changes = piece.carried(result.changes, length, result.integral_changes);
    const State before = piece.after(length);
    result.end = event ? switched(model, before, event->to) : before;
    if (!event && length == end - piece.start().time) result.end.time = end;
    if (event && changes.cols() > 0)
      result.changes = switched_changes(model, before, result.end, result.changes);
  }
  return result;
}

State next_event_state(const Model& model, double velocity, const State& start, double horizon) {
  const Piece piece(model, velocity, start);
  const auto event = piece.next_event(horizon);
  if (!event) return piece.after(horizon);
  return switched(model, piece.after(event->duration), event->to);
}

}  // namespace vcrit::simulation
