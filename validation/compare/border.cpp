#include "compare/border.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "base/constants.hpp"
#include "base/rounded.hpp"
#include "compare/system_size.hpp"
#include "compare/velocity_comparisons.hpp"
#include "critical/conditioning.hpp"
#include "simulation/methods/methods.hpp"
#include "simulation/steady/exact.hpp"
#include "simulation/steady/normal_force.hpp"

namespace vcrit::validation {

namespace {

using simulation::Method;
using simulation::Regime;
using simulation::Start;
using simulation::System;

// Who marches, how far from v* to either side, a share of it, and from where. First those that meet
// stick as it is, the most accurate one, then one for stiff systems; then one of fixed steps, which
// misses the shortest sticks. From rest a body on a soft drive rings for thousands of periods, of
// which one that slides has none: friction has one steady value from both (docs/physics.md).
struct March {
  Method method;
  double share;
  Start start = Start::rest;
};
constexpr std::array marches{March{Method::rk8pd, 1e-3},
                             March{Method::msbdf, 1e-3},
                             March{Method::moreau, 1e-3},
                             March{Method::moreau, 1e-2},
                             March{Method::rk8pd, 1e-3, Start::sliding},
                             March{Method::moreau, 1e-3, Start::sliding}};
// In a period. A stick 0.001 below v* lasts for 2 sqrt(0.002) rad, some 280 of them.
constexpr int march_steps = 20'000;

// 0.001 below v* the least that stick takes of friction: the square of that, by about 0.01 of the
// amplitude. A method whose error is larger may miss it, or see one that is none.
constexpr double least_stick = 1e-8;

Comparison of_velocity(const Border& border, double uncertainty, const char* key,
                       std::string name) {
  Comparison comparison;
  comparison.key = key;
  comparison.name = std::move(name);
  comparison.reference = border.reference;
  comparison.unit = "m/s";
  comparison.expected = border.contact_velocity;
  const double open = uncertainty + border.uncertainty;
  comparison.tolerance = motion_tolerance(border.condition) + open / border.contact_velocity;
  comparison.reason =
      motion_tolerance(border.condition) > motion_promise
          ? fmt::format(
                "motion in closed form, in doubles: 32 roundings of 2⁻⁵³, times the condition "
                "number {:.3g} of Eq. 24 here",
                border.condition)
          : "motion in closed form, in doubles: leaves six digits to lose near resonance";
  if (open > 0)
    comparison.reason += fmt::format("; and ±{}, {}", rounded(open, "m/s", 2), border.why);
  return comparison;
}

bool still_sticks(Regime regime) {
  return regime != Regime::sliding && regime != Regime::sliding_separated;
}

struct Marched {
  bool sticks = false, tells = false;
};

Marched march(Method method, const System& system, double velocity, Start start = Start::rest) {
  simulation::MethodOptions options = affordable(system);
  options.start = start;
  options.steps_per_period = march_steps;
  const auto state = simulation::steady_state(method, system, velocity, options);
  return {still_sticks(state.regime), state.friction_ratio_error <= least_stick};
}

}  // namespace

Border simulated_border(const CriticalOnset& onset) {
  const double velocity = onset.contact_velocity;
  if (std::isinf(velocity))
    return {velocity, velocity, 0, fmt::format("{}: none, {}", simulated_reference, onset.reason)};
  return {velocity, onset.drive_velocity, 0, simulated_reference, onset.relative_error * velocity};
}

Comparison compare_last_stick(const Border& border, const simulation::Onset& last_stick) {
  Comparison comparison = of_velocity(border, last_stick.uncertainty, "simulation",
                                      "stick-slip motion: the last stick of starts at rest");
  comparison.found = last_stick.contact_velocity;
  return comparison;
}

std::optional<Comparison> compare_creep(const Border& border, const simulation::Onset& last_stick) {
  if (!(border.drive_velocity > border.contact_velocity)) return std::nullopt;
  Comparison comparison = of_velocity(border, last_stick.uncertainty, "creep",
                                      "stick-slip motion: speed of the far end at the last stick");
  comparison.reference = "v* and creep under the mean friction force";
  comparison.expected = border.drive_velocity;
  comparison.found = last_stick.drive_velocity;
  return comparison;
}

std::optional<Comparison> compare_evaluators(const std::vector<Comparison>& velocities,
                                             const simulation::Onset& last_stick,
                                             double condition) {
  std::optional<Comparison> farthest;
  for (const Comparison& evaluated : velocities) {
    if (evaluated.not_run || evaluated.broken) continue;
    Comparison comparison = of_velocity(
        {last_stick.contact_velocity, last_stick.drive_velocity, condition,
         "stick-slip motion: the last stick of starts at rest"},
        last_stick.uncertainty, "evaluators", "formula or evaluator farthest from the motion");
    comparison.found = evaluated.found;
    comparison.detail = evaluated.name;
    if (!farthest || difference(comparison) > difference(*farthest)) farthest = comparison;
  }
  return farthest;
}

namespace {

// In units of mu0 <F_n> omega/|K_t|: far above every speed that such a scene has, and slow enough
// that a stick of a part in so many of a radian is one for a method of 20,000 steps.
constexpr double very_fast = 100;

double very_fast_speed(const System& system) {
  return very_fast * system.friction * simulation::mean_normal_force(system) * system.omega /
         std::abs(dynamic_stiffness(system.contact, system.omega));
}

// Found: infinite if it still sticks, else the speed at which it does not.
Comparison without_end(const Border& border, const char* key, double velocity) {
  Comparison comparison = of_velocity(border, 0, key, "");
  comparison.tolerance = 0;
  comparison.reason = "it sticks or it does not";
  comparison.found = velocity;
  return comparison;
}

}  // namespace

Comparison compare_stick_without_end(const Border& border, const System& system) {
  const double velocity = very_fast_speed(system);
  Comparison comparison = without_end(border, "simulation", velocity);
  comparison.name = fmt::format(
      "stick-slip motion at {} mu0 ⟨F_n⟩ ω/|K_t|: it still sticks in each period", very_fast);
  try {
    const auto state = simulation::steady_state(system, velocity, simulation::Start::rest);
    if (still_sticks(state.regime)) comparison.found = infinity;
  } catch (const ModelError& error) {
    return not_run(comparison, error.what());
  }
  return comparison;
}

Comparison compare_march_without_end(const Border& border, const System& system) {
  const double velocity = very_fast_speed(system);
  Comparison comparison = without_end(border, "marched", velocity);
  std::string why;
  for (const Method method : {Method::rk8pd, Method::msbdf, Method::moreau}) {
    comparison.name = fmt::format("marched by {} at {} mu0 ⟨F_n⟩ ω/|K_t|: it still sticks",
                                  to_text(method), very_fast);
    try {
      const Marched found = march(method, system, velocity);
      if (found.sticks) comparison.found = infinity;
      return comparison;
    } catch (const ModelError& error) {
      why += fmt::format("{}; ", error.what());
    }
  }
  comparison.name = "marched by another method at a speed above all others";
  return not_run(comparison, why.substr(0, why.size() - 2));
}

Comparison compare_march(const Border& border, const System& system) {
  const double creep = border.drive_velocity - border.contact_velocity;
  Comparison comparison = of_velocity(border, 0, "marched", "");
  comparison.reason = "the speeds that were marched at";
  comparison.found = border.contact_velocity;
  // At a free harmonic a motion that stuck ends in one whose sticks last no time, at any speed
  // above the border: that it sticks tells nothing there.
  const std::string endless =
      simulation::free_harmonic(system) > 1 ? simulation::why_sticks_linger(system) : "";
  std::string why;
  std::optional<std::pair<Method, Start>> unsettled;
  for (const auto& [method, share, start] : marches) {
    if (std::pair(method, start) == unsettled) continue;  // farther from v* bodies ring as long
    // Where sticks linger, what slides tells nothing of what stuck before.
    if (start == Start::sliding && !simulation::why_sticks_linger(system).empty()) continue;
    comparison.name =
        fmt::format("marched by {}: starts {} stick at {} v* and slide at {} v*", to_text(method),
                    start == Start::rest ? "at rest" : "in sliding", 1 - share, 1 + share);
    comparison.tolerance = share;
    const auto at = [&](double ratio) {
      return march(method, system, ratio * border.contact_velocity + creep, start);
    };
    try {
      const Marched below = at(1 - share), above = at(1 + share);
      comparison.detail.clear();
      if (below.sticks && !above.sticks) return comparison;
      if (above.sticks && !endless.empty()) {
        why += fmt::format("{}; ", endless);
        continue;
      }
      comparison.detail = above.sticks ? "it still sticks above v*" : "it slides below v* already";
      comparison.broken = above.sticks ? above.tells : below.tells;
      if (comparison.broken) return comparison;
      why += fmt::format("{} says that {}, within its error; ", to_text(method), comparison.detail);
    } catch (const ModelError& error) {
      why += fmt::format("{}; ", error.what());
      unsettled = {method, start};
    }
  }
  comparison.name = "marched by another method just below and above v*";
  return not_run(comparison, why.substr(0, why.size() - 2));
}

}  // namespace vcrit::validation
