#include "simulation/motion/trace.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "base/errors.hpp"
#include "simulation/motion/switching.hpp"

namespace vcrit::simulation {

namespace {

// Two events in a row without time between them are one touch within rounding: the motion goes on
// without them for this share of a radian, over which nothing can be gained or lost. So does one
// that ends as it begins, but is within its law a touch, or some of them, later: what relaxes at
// once leaves its rounding error in the rates of what comes after.
constexpr double shortest_touch = 1e-9, longest_touch = 1e-7;

// Member by member: an initialiser would clear the room for all parts first.
void begin(Trace& record, const Model& model, const State& start, const Matrix& changes) {
  const Index integrals = model.integrals();
  record.end = start;
  record.integrals.resize(integrals);
  record.changes = {changes, Matrix(integrals, changes.columns())};
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
    auto& [piece, length] = record_.parts.emplace_back(model_, velocity_, record_.end);
    length = end - record_.end.at.time;
    const auto change = next_opening_or_closing(length);
    if (change) length = *change;
    auto event = piece.next_event(length);
    const bool to_end = !event && !change, undisturbed = !event;
    if (event && event->duration == 0)
      if (const auto passed = touched(piece, event->to)) {
        event.reset();
        length = std::min(length, *passed);
      }
    if (event) length = event->duration;
    stood_ = length == 0;
    const Flow flow = piece.flow(length);
    flow.carry(record_.changes);
    record_.end = piece.after(flow, record_.integrals);
    if (to_end) record_.end.at = end;
    if (event) change_motion(piece, flow, event->to);
    if (change && undisturbed) part_or_meet();
  }

  // Of a contact that opens: how long until then, if that is before the end.
  std::optional<double> next_opening_or_closing(double end) const {
    if (!model_.opening) return std::nullopt;
    const State& now = record_.end;
    const double left = now.motion == Motion::separated
                            ? model_.opening->until_closed(now.touch, now.at.time)
                            : model_.opening->until_opened(now.touch, now.at.time);
    return left < end ? std::optional(left) : std::nullopt;
  }

  void part_or_meet() {
    const bool separated = record_.end.motion == Motion::separated;
    State& now = record_.end;
    now = separated ? after_closing(model_, velocity_, now) : after_opening(model_, now);
    left_ = Motion::separated;  // nothing before this can be undone
    Matrix& changes = record_.changes.state;
    if (changes.columns() == 0) return;
    separated ? carry_over_closing(model_, now, changes) : carry_over_opening(model_, changes);
  }

  // How long the motion goes on in spite of an event at its beginning.
  std::optional<double> touched(const Piece& piece, Motion to) {
    for (double passed = shortest_touch; passed <= longest_touch; passed *= 10)
      if (piece.event_function(to).at(piece.flow(passed).factors()).value < 0) return passed;
    if (!stood_) return std::nullopt;
    record_.unlawful += shortest_touch;
    return shortest_touch;
  }

  void change_motion(const Piece& piece, const Flow& flow, Motion to) {
    const State before = std::exchange(record_.end, switched(model_, record_.end, to));
    Matrix& changes = record_.changes.state;
    if (changes.columns() == 0) return;
    // What is begun and left without time changes nothing, and has no slope to tell a shift by.
    const bool undone = stood_ && to == left_;
    left_ = before.motion;
    std::swap(changes, untouched_);
    if (undone) return;
    changes = untouched_;
    const double slope = piece.event_function(to).at(flow.factors()).slope;
    const Vector shifts = event_shifts(model_, before, to, slope, changes);
    carry_across(model_, before, record_.end, shifts, changes);
  }

  const Model& model_;
  double velocity_;
  Trace& record_;
  bool stood_ = false;  // the last piece had no duration
  Motion left_ = Motion::slip;
  Matrix untouched_;  // changes before the last event, in the motion left there
};

}  // namespace

Trace trace(const Model& model, double velocity, const State& start, double duration,
            const Matrix& changes, std::size_t parts) {
  Trace record;
  begin(record, model, start, changes);
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
