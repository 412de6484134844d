#include "simulation/motion/trace.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/errors.hpp"
#include "simulation/motion/switching.hpp"

namespace vcrit::simulation {

namespace {

// Two events in a row without time between them are one touch within rounding: the motion goes on
// without them for this share of a period, over which nothing can be gained or lost.
constexpr double touch = 1e-9;

Trace begun(const Model& model, const State& start, const Matrix& changes) {
  const Index integrals = model.integrals();
  return {{start, Vector(integrals), {changes, Matrix(integrals, changes.columns())}}, {}};
}

class Tracer {
 public:
  Tracer(const Model& model, double velocity, Trace& record)
      : model_(model), velocity_(velocity), record_(record) {}

  void run(double duration, std::size_t parts) {
    const double end = record_.end.at.time + duration;
    if (!(end > record_.end.at.time)) throw ModelError("the motion grows beyond all bounds");
    while (record_.end.at.time < end) {
      if (record_.parts.size() == parts)
        throw ModelError(fmt::format(
            "stick and slip alternate more than {} times within one period: the body rings",
            parts));
      add_part(end);
    }
  }

 private:
  void add_part(double end) {
    auto& [piece, length] =
        record_.parts.emplace_back(Trace::Part{Piece(model_, velocity_, record_.end), 0});
    length = end - record_.end.at.time;
    auto event = piece.next_event(length);
    const bool to_end = !event;
    if (event && event->duration == 0 && stood_) {
      event.reset();
      length = std::min(length, touch);
    }
    if (event) length = event->duration;
    stood_ = length == 0;
    const Flow flow = piece.flow(length);
    flow.carry(record_.changes);
    record_.end = piece.after(flow, record_.integrals);
    if (to_end) record_.end.at = end;
    if (event) change_motion(piece, flow, event->to);
  }

  void change_motion(const Piece& piece, const Flow& flow, Motion to) {
    const State before = std::exchange(record_.end, switched(model_, record_.end, to));
    Matrix& changes = record_.changes.state;
    if (changes.columns() == 0) return;
    const double slope = piece.event_function(to).at(flow.factors()).slope;
    const Vector shifts = event_shifts(model_, before, to, slope, changes);
    carry_across(model_, before, record_.end, shifts, changes);
  }

  const Model& model_;
  double velocity_;
  Trace& record_;
  bool stood_ = false;
};

}  // namespace

Trace trace(const Model& model, double velocity, const State& start, double duration,
            const Matrix& changes, std::size_t parts) {
  Trace record = begun(model, start, changes);
  Tracer(model, velocity, record).run(duration, parts);
  return record;
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
