#include "simulation/steady/forward_sliding.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "modes/highest.hpp"
#include "simulation/steady/closing.hpp"
#include "simulation/steady/far_apart.hpp"
#include "simulation/steady/steady_cycle.hpp"

namespace vcrit::simulation {

namespace {

// Of the drive, so that the contact always slips: the motion beside it does not depend on it.
constexpr double any_speed = 1e100;

constexpr const char* lost_in_rounding =
    "body and drive are so close to a resonance with the force of a contact that opens, or settle "
    "so "
    "slowly, that the swing in slip is lost in rounding";
constexpr const char* neither_driven_nor_damped =
    "body and drive swing freely at a harmonic that the force of a contact that opens does not "
    "have: "
    "v* depends on a swing that nothing decides";

// The map of a period is linear: the second one closes the cycle, the others take off rounding
// errors as far as that goes.
constexpr int most_steps = 8;

// A cycle is closed where so many rounding errors are left of the residual.
constexpr double closed = 100;

// The drive's speed with fewer digits than this is none, nor is v*, which is that less the creep.
constexpr double worst_error = 1e-6, worst_error_without_creep = 1e-2;

struct SlidingCycle {
  Trace period;
  double error;  ///< of the contact velocity, without dimension
};

double in_roundings(const Vector& residual, const Vector& unit) {
  double size = 0;
  for (Index i = 0; i < unit.size(); ++i) size = std::max(size, std::abs(residual[i]) / unit[i]);
  return size;
}

// What a change of the state does to the contact velocity at most.
double effect(const Model& model, ConstView change) {
  double sum = 0;
  if (model.body) sum += std::abs(change[0]) + swing(model, change.first(model.body_states()));
  for (Index j = model.body_states(); j < change.size(); ++j) sum += std::abs(change[j]);
  return sum;
}

// Of the steady contact velocity: what is left of the residual, and a rounding error of each number
// of the state.
double error_of(const Model& model, const LinearSolver& solver, const Vector& residual,
                const Vector& unit) {
  const Index n = unit.size();
  model.effort.spend(Effort::of_products(n * n * n));
  double sum = effect(model, solver.solve(residual));
  for (Index i = 0; i < n; ++i) {
    Vector one(n);
    one[i] = unit[i];
    sum += effect(model, solver.solve(one));
  }
  return sum;
}

SlidingCycle sliding_cycle(const Model& model) {
  State state = separated_start(model, any_speed, false);
  const Index changing = state.x.size() - 1;
  for (int i = 1;; ++i) {
    Trace period = trace(model, any_speed, state, two_pi, unit_changes(state, changing));
    Closing left = closing(model, state, period);
    const double impulse_rounding = close_heavy_body(model, period, left);
    const LinearSolver solver = counted_solver(model, left.derivative, state_size(model, 0, state));
    Vector unit = slip_rounding(model, state);
    if (impulse_rounding > 0) unit[0] = impulse_rounding;
    if (i == most_steps || in_roundings(left.residual, unit) <= closed)
      return {std::move(period), error_of(model, solver, left.residual, unit)};
    const Vector step = solver.solve(left.residual);
    for (Index j = 0; j < changing; ++j) state.x[1 + j] += step[j];
  }
}

// Whether a period of the force leaves a body that swings freely in it with another swing: whether
// the force has the harmonic of the swing, by more than rounding. The first one it always has, as
// it follows the oscillation.
bool drives_the_body(const Model& model) {
  if (model.free_harmonic == 1) return true;
  const State state = separated_start(model, any_speed, false);
  const Trace period = trace(model, any_speed, state, two_pi);
  const Vector unit = slip_rounding(model, period.end);
  for (Index i = 0; i < model.body_states(); ++i)
    if (std::abs(period.end.x[1 + i] - state.x[1 + i]) > closed * unit[i]) return true;
  return false;
}

// What rounding the bound does to the contact velocity. A surface that comes back far faster than
// the oscillation goes closes with a force far below its amplitude, and as fast a contact point
// follows that.
double rounding_of_the_bound(const Model& model) {
  const Opening& opening = *model.opening;
  double fluidity = model.contact.fluidity, rate = opening.amplitude;
  for (const double each : model.contact.unit_fluidity) fluidity += each;
  for (const Opening::Touch& touch : opening.touches)
    for (Index i = 0; i < opening.rates.size(); ++i)
      rate += opening.rates[i] * std::abs(touch.decaying[i]);
  return 4 * epsilon * (fluidity * parts_of_bound(opening) + model.contact.glassy * rate);
}

// The velocity of the drive that is just enough for a piece of slip.
double least_velocity(const Model& model, const Trace::Part& part) {
  State start = part.piece.start();
  start.entered = 0;  // its velocity counts, whatever it is
  EventFunction backward = Piece(model, 0, start).event_function(Motion::stick);
  return highest(backward, part.duration);
}

ForwardSliding sliding_without_stick(const Model& model) {
  using Ends = ForwardSliding::Ends;
  if (model.opening->answers_at_once) lost_at_closings();
  if (model.opening->jumps && model.contact.damper == 0)
    return {Ends::sticks_at_closings, infinity};
  if (model.free_harmonic > 0) {
    if (!drives_the_body(model)) throw ModelError(neither_driven_nor_damped);
    return {Ends::in_resonance, infinity};
  }
  check_settles(model);
  check_closings(model);
  const SlidingCycle cycle = sliding_cycle(model);
  double least = -infinity;
  for (const Trace::Part& part : cycle.period.parts)
    if (part.piece.start().motion == Motion::slip)
      least = std::max(least, least_velocity(model, part));
  if (!(cycle.error <= worst_error * std::abs(least) &&
        cycle.error <= worst_error_without_creep * std::abs(least - model.creep)))
    throw ModelError(lost_in_rounding);
  const double bound = rounding_of_the_bound(model);
  if (!(bound <= worst_error_without_creep * std::abs(least - model.creep))) lost_at_closings();
  // The contact's velocity is rounded once more where it is least.
  return {Ends::at_a_speed, least, cycle.error + bound + 4 * epsilon * std::abs(least)};
}

}  // namespace

ForwardSliding forward_sliding(const Model& model) {
  try {
    return sliding_without_stick(model);
  } catch (const ModelError& last) {
    no_motion_found(model, last);
  }
}

}  // namespace vcrit::simulation
