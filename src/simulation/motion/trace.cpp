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
  const Index integrals = model.integrals();
  Trace result{{start, Vector(integrals), {changes, Matrix(integrals, changes.columns())}}, {}};
  const double end = start.at.time + duration;
  bool stood = false;
  while (result.end.at.time < end) {
    if (result.parts.size() == most_parts)
      throw ModelError("stick and slip alternate without end within one period");
    const Piece& piece =
        result.parts.emplace_back(Trace::Part{Piece(model, velocity, result.end), 0}).piece;
    double length = end - result.end.at.time;
    auto event = piece.next_event(length);
    if (event && event->duration == 0 && stood) {
      event.reset();
      length = std::min(length, touch);
    }
    if (event) length = event->duration;
    stood = length == 0;
    result.parts.back().duration = length;
    const Flow flow = piece.flow(length);
    flow.carry(result.changes);
    const bool last = !event && length == end - piece.start().at.time;
    result.end = piece.after(flow, result.integrals);
    if (last) result.end.at = end;
    if (!event) continue;
    const State before = std::exchange(result.end, switched(model, result.end, event->to));
    if (changes.columns() == 0) continue;
    const double slope = piece.event_function(event->to).at(flow.factors()).slope;
    carry_across(model, before, result.end,
                 event_shifts(model, before, event->to, slope, result.changes.state),
                 result.changes.state);
  }
  return result;
}

State next_event_state(const Model& model, double velocity, const State& start, double horizon) {
  const Piece piece(model, velocity, start);
  const auto event = piece.next_event(horizon);
  if (!event) return piece.after(horizon);
  return switched(model, piece.after(event->duration), event->to);
}

Matrix unit_changes(const State& slip, Index columns) {
  Matrix changes(slip.x.size(), columns);
  for (Index j = 0; j + 1 < slip.x.size(); ++j) changes(j + 1, j) = 1;
  return changes;
}

}  // namespace vcrit::simulation
