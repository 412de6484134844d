#include "simulation/motion/course.hpp"

#include <numbers>

#include "simulation/motion/switching.hpp"

namespace vcrit::simulation {

namespace {

constexpr double period = 2 * std::numbers::pi;

const Trace::Part* longest_slip(const Trace& trace) {
  const Trace::Part* longest = nullptr;
  for (const Trace::Part& part : trace.parts)
    if (part.piece.start().motion == Motion::slip &&
        (!longest || part.duration > longest->duration))
      longest = &part;
  return longest;
}

// Motions that go on are joined: at touches, and where the record ends and begins.
bool append(Course& course, Motion motion, double duration) {
  if (!course.legs.empty()) {
    Course::Leg& last = course.legs.back();
    if (last.motion == motion) {
      last.duration += duration;
      return true;
    }
    if ((last.motion == Motion::stick) == (motion == Motion::stick)) return false;
  }
  course.legs.push_back({motion, duration});
  return true;
}

}  // namespace

std::optional<Course> course_of(const Trace& trace) {
  const Trace::Part* longest = longest_slip(trace);
  if (!longest) return std::nullopt;
  const double half = 0.5 * longest->duration;
  Course course{longest->piece.after(half), {}};
  const double time = course.start.at.time;
  course.start.at = time - period * std::floor(time / period);
  bool repeats = append(course, Motion::slip, half);
  const auto add = [&](const Trace::Part* from, const Trace::Part* to) {
    for (; from != to; ++from)
      repeats = append(course, from->piece.start().motion, from->duration) && repeats;
  };
  add(longest + 1, trace.parts.data() + trace.parts.size());
  add(trace.parts.data(), longest);
  repeats = append(course, Motion::slip, half) && repeats;
  if (!repeats) return std::nullopt;
  return course;
}

bool shift_events(Course& course, const Vector& shifts) {
  double before = 0;
  bool in_order = true;
  for (Index i = 0; i < course.legs.size(); ++i) {
    const double after = i < shifts.size() ? shifts[i] : 0;
    course.legs[i].duration += after - before;
    in_order = in_order && course.legs[i].duration > 0;
    before = after;
  }
  return in_order;
}

CoursePassage follow(const Model& model, double velocity, const Course& course) {
  const Index columns = course.start.x.size(), levels = model.level_states();
  CoursePassage result{{course.start,
                        Vector(levels),
                        {unit_changes(course.start, columns), Matrix(levels, columns)}},
                       Matrix(columns, course.legs.size() - 1)};
  for (Index i = 0; i < course.legs.size(); ++i) {
    const Piece piece(model, velocity, result.end);
    const Flow flow = piece.flow(course.legs[i].duration);
    flow.carry(result.changes);
    result.end = piece.after(flow, result.integrals);
    if (i + 1 == course.legs.size()) break;
    const Motion to = course.legs[i + 1].motion;
    const EventFunction::Point event = piece.event_function(to).at(flow.factors());
    const State before = std::exchange(result.end, switched(model, result.end, to));
    Vector shifts = event_shifts(model, before, to, event.slope, result.changes.state);
    shifts.back() -= event.value / event.slope;
    carry_across(model, before, result.end, shifts, result.changes.state);
    std::copy(shifts.begin(), shifts.end(), result.shifts.column(i).begin());
  }
  return result;
}

}  // namespace vcrit::simulation
