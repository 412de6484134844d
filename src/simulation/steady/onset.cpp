#include "simulation/steady/onset.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/errors.hpp"
#include "simulation/steady/forward_sliding.hpp"
#include "simulation/steady/steady_cycle.hpp"

namespace vcrit::simulation {

namespace {

// In units of mu0 <F_n> omega/|K_t|, by which no sensible v* differs so much.
constexpr double lowest_speed = 1e-30, highest_speed = 1e30;

// velocity: as in model.hpp.
bool sticks(const Model& model, double velocity) {
  const auto& parts = steady_cycle(model, velocity, rest_start(model, velocity)).period.parts;
  return std::any_of(parts.begin(), parts.end(), [](const Trace::Part& part) {
    return part.piece.start().motion == Motion::stick;
  });
}

std::string why_infinite(ForwardSliding::Ends ends) {
  switch (ends) {
    case ForwardSliding::Ends::at_a_speed:
      return "";
    case ForwardSliding::Ends::sticks_at_meetings:
      return "the contact sticks for a moment each time the surfaces meet: the normal force jumps "
             "and the tangential one cannot";
    case ForwardSliding::Ends::in_resonance:
      return "body and drive are in undamped resonance with a harmonic of the normal force, which "
             "parting gives it: the swing in slip grows without bound";
  }
  throw Bug("an end of forward sliding without a word");
}

}  // namespace

Onset sliding_threshold(const System& system) {
  const Model model(system);
  if (model.opening) {
    const ForwardSliding sliding = forward_sliding(model);
    const double drive = sliding.least_velocity;
    return {(drive - model.creep) * model.velocity_unit, drive * model.velocity_unit,
            why_infinite(sliding.ends)};
  }
  const double lowest = model.threshold;
  return {lowest * model.velocity_unit, (lowest + model.creep) * model.velocity_unit};
}

Onset stick_onset(const System& given) {
  System system = given;
  Effort effort(effort_of_answer, given.effort);
  system.effort = &effort;
  const Model model(system);
  if (const int n = nearly_free_harmonic(system); !model.opening && n > 1)
    throw ModelError(
        fmt::format("the body swings freely at harmonic {} of the oscillation{} and loses its "
                    "sticks ever more slowly: no steady state tells where the last one ends",
                    n, model.free_harmonic > 1 ? "" : ", within a part in 1e5,"));
  double low = 1, high = 2;
  while (!sticks(model, low) && low > lowest_speed) high = std::exchange(low, low / 2);
  while (sticks(model, high)) {
    if (high > highest_speed) throw ModelError("stick vanishes at no speed");
    low = std::exchange(high, 2 * high);
  }
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    (sticks(model, middle) ? low : high) = middle;
  }
  const double contact = low - (model.creep - model.creep * model.load);
  return {contact * model.velocity_unit, (contact + model.creep) * model.velocity_unit};
}

}  // namespace vcrit::simulation
