#include "simulation/steady/onset.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "simulation/steady/closing.hpp"
#include "simulation/steady/forward_sliding.hpp"
#include "simulation/steady/steady_cycle.hpp"

namespace vcrit::simulation {

namespace {

// In units of mu0 <F_n> omega/|K_t|, by which no sensible v* differs so much.
constexpr double lowest_speed = 1e-30, highest_speed = 1e30;

constexpr const char* too_near_resonance =
    "body and drive are so near a resonance or antiresonance that no cycle closes well enough to "
    "tell where the last stick ends";

bool sticks(const SteadyCycle& cycle) {
  const auto& parts = cycle.period.parts;
  return std::any_of(parts.begin(), parts.end(), [](const Trace::Part& part) {
    return part.piece.start().motion == Motion::stick;
  });
}

// Speeds below: as in model.hpp.
bool sticks(const Model& model, double velocity) {
  return sticks(steady_cycle(model, velocity, rest_start(model, velocity)));
}

// Nothing where no cycle closes well enough to tell.
std::optional<bool> surely_sticks(const Model& model, double velocity) {
  const auto cycle = strictly_steady_cycle(model, velocity, rest_start(model, velocity));
  return cycle ? std::optional(sticks(*cycle)) : std::nullopt;
}

// The highest speed that is known to stick, and the lowest known not to.
struct SpeedBracket {
  double low, high;

  void hear(double velocity, bool sticks) { (sticks ? low : high) = velocity; }
};

// From speeds between which a cycle that is nearly closed loses its stick: away from them, ever
// faster, until one that is closed sticks below and another one slips above.
SpeedBracket sure_bracket(const Model& model, SpeedBracket near) {
  // From some roundings of the speed to where no rounding reaches.
  constexpr double first = 1e-15, farthest = 1e-2;
  for (const double side : {-1.0, 1.0}) {
    double& end = side < 0 ? near.low : near.high;
    const double from = end;
    for (double away = first; surely_sticks(model, end) != (side < 0); away *= 4) {
      if (away > farthest) throw ModelError(too_near_resonance);
      end = from * (1 + side * away);
    }
  }
  return near;
}

// Closes in on the last stick as far as cycles tell.
SpeedBracket closed_in(const Model& model, SpeedBracket bracket) {
  // Some roundings of the speed.
  constexpr double finest = 1e-15;
  const auto narrow = [&] {
    for (const double share : {0.5, 0.25, 0.75}) {
      const double middle = bracket.low + share * (bracket.high - bracket.low);
      if (const auto sticks = surely_sticks(model, middle)) {
        bracket.hear(middle, *sticks);
        return true;
      }
    }
    return false;
  };
  while (bracket.high - bracket.low > finest * bracket.high && narrow()) continue;
  return bracket;
}

std::string why_infinite(ForwardSliding::Ends ends) {
  switch (ends) {
    case ForwardSliding::Ends::at_a_speed:
      return "";
    case ForwardSliding::Ends::sticks_at_closings:
      return "the contact sticks for a moment each time the contact closes: the normal force jumps "
             "and the tangential one cannot";
    case ForwardSliding::Ends::in_resonance:
      return "body and drive are in undamped resonance with a harmonic of the normal force, which "
             "separation gives it: the swing in slip grows without bound";
  }
  throw Bug("an end of forward sliding without a word");
}

}  // namespace

Onset sliding_threshold(const System& system) {
  const Model model(system);
  // Also of a contact that hardly opens, so that rounding hides it.
  if (!model.opening && system.opening && modes_of(*system.opening, system.omega).damper > 0 &&
      model.contact.damper == 0)
    return {infinity, infinity, why_infinite(ForwardSliding::Ends::sticks_at_closings)};
  if (model.opening) {
    const ForwardSliding sliding = forward_sliding(model);
    const double drive = sliding.least_velocity;
    return {(drive - model.creep) * model.velocity_unit, drive * model.velocity_unit,
            why_infinite(sliding.ends), sliding.error * model.velocity_unit};
  }
  const double lowest = model.threshold;
  return {lowest * model.velocity_unit,
          (lowest + model.creep) * model.velocity_unit,
          {},
          (model.bound_error() * std::abs(lowest) + model.threshold_error) * model.velocity_unit};
}

Onset stick_onset(const System& given) {
  System system = given;
  SharedEffort effort(effort_of_answer, given.effort);
  system.effort = &effort;
  const Model model(system);
  if (const std::string why = why_sticks_linger(system); !model.opening && !why.empty())
    throw ModelError(why);
  check_cycles_settle(model);
  double low = 1, high = 2;
  while (!sticks(model, low) && low > lowest_speed) high = std::exchange(low, low / 2);
  if (!(low > lowest_speed)) throw ModelError("a motion from rest sticks at no speed");
  while (sticks(model, high)) {
    if (high > highest_speed) throw ModelError("stick vanishes at no speed");
    low = std::exchange(high, 2 * high);
  }
  SpeedBracket bracket{low, high};
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (bracket.low + bracket.high);
    bracket.hear(middle, sticks(model, middle));
  }
  double uncertainty = 0;
  if (surely_sticks(model, bracket.low) != true || surely_sticks(model, bracket.high) != false) {
    bracket = closed_in(model, sure_bracket(model, bracket));
    uncertainty = 0.5 * (bracket.high - bracket.low);
  }
  const double contact = bracket.low + uncertainty - (model.creep - model.creep * model.load);
  return {contact * model.velocity_unit,
          (contact + model.creep) * model.velocity_unit,
          {},
          (uncertainty + model.threshold_error) * model.velocity_unit};
}

}  // namespace vcrit::simulation
