#include "simulation/motion/course.hpp"

#include <algorithm>

#include "simulation/motion/switching.hpp"

namespace vcrit::simulation {

namespace {

// Parts of a trace that go on in the same motion are one leg, also across its end.
struct TraceLeg {
  const Trace::Part* first;
  double duration;
  Motion motion() const { return first->piece.start().motion; }
};

List<TraceLeg, 8> legs_of(const Trace& trace) {
  List<TraceLeg, 8> result;
  for (const Trace::Part& part : trace.parts) {
    if (!result.empty() && result.back().motion() == part.piece.start().motion)
      result.back().duration += part.duration;
    else
      result.push_back({&part, part.duration});
  }
  if (result.size() > 1 && result.front().motion() == result.back().motion()) {
    result.front() = {result.back().first, result.front().duration + result.back().duration};
    result.pop_back();
  }
  return result;
}

}  // namespace

std::optional<Course> course_of(const Trace& trace) {
  const auto legs = legs_of(trace);
  const Index n = legs.size();
  Index longest = n;
  for (Index i = 0; i < n; ++i)
    if (legs[i].motion() == Motion::slip &&
        (longest == n || legs[i].duration > legs[longest].duration))
      longest = i;
  if (longest == n || n % 2 != 0) return std::nullopt;
  Course course{legs[longest].first->piece.start(), {}};
  course.start.entered = 1;
  for (Index i = 0; i < n; ++i) {
    const TraceLeg &leg = legs[(longest + i) % n], &next = legs[(longest + i + 1) % n];
    if ((leg.motion() == Motion::stick) == (next.motion() == Motion::stick)) return std::nullopt;
    course.legs.push_back({leg.motion(), leg.duration});
  }
  return course;
}

namespace {

// Changes of the start at fixed time: a slip that begins later is behind by its rates.
Matrix start_changes(const Model& model, const State& start) {
  Matrix changes = unit_changes(start, start.x.size() + 1);
  const Vector rate = rate_of(model, start);
  for (Index i = 1; i < rate.size(); ++i) changes(i, start.x.size() - 1) = -rate[i];
  return changes;
}

// What is integrated, of a state in slip.
Vector integrand(const Model& model, const State& state) {
  const ConstView x = state.x, levels = x.first(model.integrated_levels());
  const ConstView units = x.subspan(model.level_states(), model.slow_units);
  Vector result(levels.begin(), levels.end());
  result.append(units.begin(), units.end());
  return result;
}

// From changes at fixed time to changes at the beginning and the end of the cycle.
void move_to_events(const Model& model, const State& start, const Vector& end_shifts,
                    CoursePassage& passage) {
  const Vector rate = rate_of(model, passage.end), level = integrand(model, passage.end);
  Matrix &state = passage.changes.state, &integrals = passage.changes.integrals;
  for (Index j = 0; j < end_shifts.size(); ++j) {
    add(rate, end_shifts[j], state.column(j));
    add(level, end_shifts[j], integrals.column(j));
  }
  add(integrand(model, start), -1, integrals.column(start.x.size() - 1));
}

}  // namespace

CoursePassage follow(const Model& model, double velocity, const Course& course) {
  const Index columns = course.start.x.size() + 1, integrals = model.integrals();
  CoursePassage result{{course.start,
                        Vector(integrals),
                        {start_changes(model, course.start), Matrix(integrals, columns)}},
                       Matrix(columns, course.legs.size())};
  Vector shifts;
  for (Index i = 0; i < course.legs.size(); ++i) {
    const Piece piece(model, velocity, result.end);
    const Flow flow = piece.flow(course.legs[i].duration);
    flow.carry(result.changes);
    const State before = piece.after(flow, result.integrals);
    const Motion to = course.legs[(i + 1) % course.legs.size()].motion;
    const EventFunction::Point event = piece.event_function(to).at(flow.factors());
    result.end = switched(model, before, to);
    shifts = event_shifts(model, before, to, event.slope, result.changes.state);
    shifts.back() -= event.value / event.slope;
    carry_across(model, before, result.end, shifts, result.changes.state);
    std::copy(shifts.begin(), shifts.end(), result.shifts.column(i).begin());
  }
  move_to_events(model, course.start, shifts, result);
  return result;
}

}  // namespace vcrit::simulation
