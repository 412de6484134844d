#include "simulation/steady/forward_sliding.hpp"

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "simulation/modes/first_zero.hpp"
#include "simulation/steady/steady_cycle.hpp"

namespace vcrit::simulation {

namespace {

// Many times what any contact velocity swings by, but for light bodies that ring.
constexpr double fast_speed = 1e6, fastest_speed = 1e30;

bool only_slips(const Trace& period) {
  return std::none_of(period.parts.begin(), period.parts.end(), [](const Trace::Part& part) {
    const Motion motion = part.piece.start().motion;
    return motion == Motion::stick || motion == Motion::backslip;
  });
}

Trace sliding_cycle(const Model& model) {
  for (double velocity = fast_speed; velocity < fastest_speed; velocity *= fast_speed) {
    Trace period = steady_cycle(model, velocity, sliding_start(model, velocity)).period;
    if (only_slips(period)) return period;
  }
  throw ModelError("the contact sticks at any speed of the drive");
}

// The next maximum of a function that grows at `begin`.
EventFunction::Point maximum(const EventFunction& f, const Spectrum& spectrum, double begin,
                             double end) {
  const auto at = [&](double time) { return f.at(Factors(spectrum, time)); };
  double low = begin, high = end;
  for (double step = 1e-9 * (end - begin); low + step < end; step *= 2) {
    if (at(low + step).slope <= 0) {
      high = low + step;
      break;
    }
    low += step;
  }
  if (high == end && at(end).slope > 0) return at(end);
  for (int i = 0; i < 200 && high - low > epsilon * high; ++i) {
    const double middle = 0.5 * (low + high);
    (at(middle).slope > 0 ? low : high) = middle;
  }
  return at(0.5 * (low + high));
}

// Raises the speed until the contact never slows to 0 in a piece of slip.
double raised(const Model& model, double velocity, const Trace::Part& part) {
  const State& start = part.piece.start();
  velocity = std::max(velocity, -contact_velocity(model, 0, start));
  while (true) {
    const Piece piece(model, velocity, start);
    EventFunction stops = piece.event_function(Motion::stick);
    const auto zero = first_zero(stops, part.duration, false);
    if (!zero) return velocity;
    const EventFunction::Point highest =
        maximum(stops, model.slip.modes.spectrum, *zero, part.duration);
    if (highest.value <= highest.noise) return velocity;
    velocity += highest.value;
  }
}

}  // namespace

double forward_sliding_threshold(const Model& model) {
  if (model.opening->jumps && model.contact.damper == 0) return infinity;
  const Trace period = sliding_cycle(model);
  double velocity = -infinity;
  for (const Trace::Part& part : period.parts)
    if (part.piece.start().motion == Motion::slip) velocity = raised(model, velocity, part);
  return velocity;
}

}  // namespace vcrit::simulation
