#include "simulation/steady/shooting.hpp"

#include <algorithm>

#include "base/constants.hpp"
#include "simulation/steady/closing.hpp"

namespace vcrit::simulation {

namespace {

// Steps shrink quadratically: one after which the next would be shorter than the first is the last.
// One shorter than the second that is not far shorter than the one before shows rounding.
constexpr double precision = 1e-16, stagnation = 1e-5;

constexpr int most_shooting_steps = 25;

// Shifts of the state, of the beginning and of all events.
struct NewtonStep {
  Vector state;
  double beginning;
  Vector events;
};

NewtonStep newton_step(const Model& model, double velocity, const Course& course) {
  const CoursePassage passage = follow(model, velocity, course);
  const Closing left = closing(model, course.start, passage);
  // Unknown are the state and the beginning; the last column of changes is known.
  const Index n = left.residual.size() + 1, last = course.legs.size() - 1;
  Matrix derivative(n, n);
  Vector residual(n);
  for (Index i = 0; i + 1 < n; ++i) {
    for (Index j = 0; j < n; ++j) derivative(i, j) = left.derivative(i, j);
    residual[i] = left.residual[i] - left.derivative(i, n);
  }
  for (Index j = 0; j < n; ++j) derivative(n - 1, j) = -passage.shifts(j, last);
  derivative(n - 1, n - 1) += 1;
  residual[n - 1] = passage.end.at.time - course.start.at.time - two_pi + passage.shifts(n, last);

  Vector sizes = state_size(model, velocity, course.start);
  sizes.push_back(1);
  const Vector solution = counted_solver(model, derivative, sizes).solve(residual);
  NewtonStep step{Vector(solution.begin(), solution.end() - 1), solution.back(), {}};
  for (Index i = 0; i < course.legs.size(); ++i) {
    double shift = passage.shifts(n, i);
    for (Index j = 0; j < n; ++j) shift += passage.shifts(j, i) * solution[j];
    step.events.push_back(shift);
  }
  return step;
}

// How much of the step leaves each motion a tenth of its duration.
double share_in_order(const Course& course, const NewtonStep& step) {
  double share = 1, before = step.beginning;
  for (Index i = 0; i < course.legs.size(); ++i) {
    const double change = step.events[i] - before, duration = course.legs[i].duration;
    if (duration + change < 0.1 * duration) share = std::min(share, 0.9 * duration / -change);
    before = step.events[i];
  }
  return share;
}

void take(const Model& model, const NewtonStep& step, double share, Course& course) {
  double before = step.beginning;
  for (Index i = 0; i < course.legs.size(); ++i) {
    course.legs[i].duration += share * (step.events[i] - before);
    before = step.events[i];
  }
  State& start = course.start;
  start.at = start.at.time + share * step.beginning;
  start.x[0] = model.slip_force(1, start.at);
  for (Index i = 0; i < step.state.size(); ++i) start.x[1 + i] += share * step.state[i];
}

// In units of the state's size and of 1/omega.
double length(const Model& model, double velocity, const Course& course, const NewtonStep& step) {
  const Vector unit = state_size(model, velocity, course.start);
  double longest = std::abs(step.beginning);
  for (Index i = 0; i < unit.size(); ++i)
    longest = std::max(longest, std::abs(step.state[i]) / unit[i]);
  for (const double shift : step.events) longest = std::max(longest, std::abs(shift));
  return longest;
}

}  // namespace

std::optional<State> shoot(const Model& model, double velocity, Course course) {
  double before = infinity;
  for (int i = 0; i < most_shooting_steps; ++i) {
    const NewtonStep step = newton_step(model, velocity, course);
    const double size = length(model, velocity, course, step);
    const double share = share_in_order(course, step);
    if (!(share > 0.1 && size < 4 * before)) return std::nullopt;
    take(model, step, share, course);
    const double shrinking = size / before, next = size * shrinking * shrinking;
    const bool converged = size < stagnation && (next < precision || shrinking > 0.1);
    before = size;
    if (!converged) continue;
    const double turns = std::floor(course.start.at.time / two_pi);
    course.start.at = course.start.at.time - two_pi * turns;
    course.start.x[0] = model.slip_force(1, course.start.at);
    const State middle =
        Piece(model, velocity, course.start).after(0.5 * course.legs.front().duration);
    if (contact_velocity(model, velocity, middle) <= 0) return std::nullopt;
    return middle;
  }
  return std::nullopt;
}

}  // namespace vcrit::simulation
