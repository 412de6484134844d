#include "answers/effect.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>

#include "answers/ringing.hpp"
#include "answers/under_load.hpp"
#include "base/constants.hpp"
#include "base/errors.hpp"
#include "critical/admissibility.hpp"
#include "indenter/friction.hpp"
#include "normal/pressed_cells.hpp"
#include "problem/variants.hpp"
#include "record/fields.hpp"
#include "rules/kinds.hpp"
#include "rules/rulebook.hpp"
#include "simulation/steady/normal_force.hpp"

namespace vcrit {

namespace {

using rules::cells_move;
using rules::Question;

// The search for the depth at the largest amplitude begins at this share of that at rest.
constexpr double least_share = 1e-3;

// Below an indenter u_z0 falls as the amplitude grows, since a rim that opens does not pull. At the
// border the pressure at the centre just touches zero, so that du_z is a share of u_z0 that the
// half-space alone decides: the border is where both carry the load.
double largest_amplitude_under_load(const Problem& problem) {
  const auto at_amplitude = [&](const Problem& of, double amplitude) {
    return of.with({{problem->amplitude.symbol, amplitude}});
  };
  const rules::Facts still(at_amplitude(problem, 0));
  const auto deepest = static_cast<double>(still.indentation());
  const Problem pressed = at_depth(problem, deepest);
  const rules::Facts here(at_amplitude(pressed, deepest));
  const auto share = static_cast<double>(still.mean_force() / here.oscillating_force());
  const double load = problem.value(*problem->load);
  const auto excess = [&](double depth) {
    return simulation::mean_force_of_cells(at_amplitude(at_depth(problem, depth), share * depth)) /
               load -
           1;
  };
  if (!(excess(deepest) > 0)) return share * deepest;  // a flat punch has no rim
  constexpr int bits = 46;
  std::uintmax_t steps = 100;
  return share * boost::math::tools::toms748_solve(excess, least_share * deepest, deepest,
                                                   boost::math::tools::eps_tolerance<double>(bits),
                                                   steps)
                     .first;
}

}  // namespace

// The stiffness at omega is the force of an amplitude of 1 m.
std::optional<double> largest_closed_amplitude(const Problem& problem) {
  const bool falls = rules::Facts(problem).depth_falls_with_amplitude();
  // At no amplitude, so that none is too large: what is left to say is of the scene's structure.
  const Problem asked = falls ? problem.with({{problem->amplitude.symbol, 0.0}}) : problem;
  if (!rules::answer(Question::mean_load, asked) ||
      !rules::answer(Question::closed_amplitude, asked))
    return std::nullopt;
  if (falls) return largest_amplitude_under_load(problem);
  const rules::Facts facts(problem.with({{problem->amplitude.symbol, 1.0}}));
  const long double most = facts.mean_force() / facts.oscillating_force();
  return most > 0 ? std::optional(static_cast<double>(most)) : std::nullopt;
}

namespace {

std::optional<double> mean_normal_force(const Problem& problem, const Effect& effect) {
  if (problem->load) return problem.value(*problem->load);
  if (cells_move(problem) || (effect.opens && !rules::answer(Question::motion, problem)))
    return std::nullopt;
  if (!effect.opens) return static_cast<double>(rules::Facts(problem).mean_force());
  try {
    return simulation::mean_normal_force(simulation::system_of(problem));
  } catch (const ModelError&) {
    return std::nullopt;  // v* may be known all the same
  }
}

void operating_point_of(const Problem& problem, Effect& effect) {
  effect.frequency = problem.value(problem->angular_frequency) / two_pi;
  effect.amplitude = problem.value(problem->amplitude);
  effect.of_vibrator = problem->mount.has_value();
  if (const auto mount = below_mount(problem)) effect.contact_amplitude = mount->amplitude;
  if (problem->load) {
    const auto pressed = under_load(problem);
    effect.under_load = true;
    effect.indentation = pressed->indentation;
    effect.sinking_velocity = pressed->sinking_velocity;
  } else {
    effect.indentation = problem.value(problem->indentation);
  }
  effect.friction_coefficient = problem.value(problem->coefficient);
  effect.below_indenter = cells_move(problem);
  effect.largest_closed_amplitude = largest_closed_amplitude(problem);
  effect.opens = rules::Facts(problem).loses_contact();
}

void velocities_of(const CriticalOnset& onset, Effect& effect) {
  effect.kind = std::isinf(onset.contact_velocity) ? Effect::Kind::all_speeds
                : onset.contact_velocity > 0       ? Effect::Kind::lowers
                                                   : Effect::Kind::never;
  effect.critical_velocity = onset.contact_velocity;
  effect.drive_velocity = onset.drive_velocity;
  effect.reduced_below = effect.kind == Effect::Kind::lowers && !onset.free_harmonics.empty()
                             ? onset.sliding_from + (onset.drive_velocity - onset.contact_velocity)
                             : onset.drive_velocity;
  effect.simulated = onset.by != CriticalOnset::By::formula;
  effect.by_phase = onset.by == CriticalOnset::By::maximum_over_the_phase;
  if (effect.simulated)
    effect.relative_error = onset.relative_error;
  else
    effect.relative_error_bound = onset.relative_error_bound;
  effect.why_infinite = onset.reason;
}

// At vanishing speed the contact slips only at the instant of least normal force, so friction is
// mu0 times that force.
double limit_at_rest(const Effect& effect) {
  return std::max(0.0, 1 - effect.amplitude / *effect.largest_closed_amplitude);
}

// A body that oscillates undamped at a harmonic while it sticks may carry more at any speed.
void require_rest(const Problem& problem) {
  // Above this the limit is reached only at speeds too low to matter.
  constexpr double most_ringing = 1e6;
  if (ringing(simulation::system_of(problem)) < most_ringing) return;
  throw ModelError(
      "the body is in undamped resonance while it sticks, so friction at rest has no known limit");
}

// Below an indenter, too, all cells stick at vanishing speed but for the instant of least normal
// force. A body that rings meanwhile may carry more, and without a damper it rings for ever.
void lowest_below_indenter(const Problem& problem, Effect& effect) {
  if (const auto holder = indenter::HalfSpace(problem).holder(); holder && holder->rings())
    throw ModelError(
        "the body swings undamped while all cells stick, so friction at rest has no known limit");
  const indenter::Pressed pressed = indenter::pressed(problem);
  if (!problem->load) effect.mean_normal_force = pressed.mean;
  effect.lowest = pressed.least / pressed.mean;
}

void lowest_of_contact(const Problem& problem, Effect& effect) {
  if (!effect.opens) require_rest(problem);
  effect.lowest = effect.opens ? 0 : limit_at_rest(effect);
}

// On a path that creeps, friction at vanishing speed is that of creep, with or without vibration.
void find_lowest(const Problem& problem, Effect& effect) {
  const bool lowers = effect.kind == Effect::Kind::lowers;
  const rules::Answer moves = rules::answer(rules::motion_question(problem), problem);
  if (lowers && !moves) effect.why_no_lowest = moves.reason;
  if (!lowers || !moves || effect.creeps()) return;
  try {
    if (cells_move(problem))
      lowest_below_indenter(problem, effect);
    else
      lowest_of_contact(problem, effect);
  } catch (const ModelError& error) {
    effect.why_no_lowest = error.what();
  }
}

std::optional<double> if_known(double value) {
  return std::isnan(value) ? std::nullopt : std::optional(value);
}

}  // namespace

const char* to_text(Effect::Kind kind) {
  switch (kind) {
    case Effect::Kind::lowers:
      return "lowers";
    case Effect::Kind::never:
      return "never";
    case Effect::Kind::all_speeds:
      return "all_speeds";
    case Effect::Kind::outside:
      return "outside";
  }
  throw Bug("an effect without a name");
}

Effect without_velocities(const Problem& problem) {
  Effect effect;
  operating_point_of(problem, effect);
  effect.reasons = inadmissible_reasons(problem);
  if (!effect.reasons.empty()) effect.kind = Effect::Kind::outside;
  effect.mean_normal_force = mean_normal_force(problem, effect);
  return effect;
}

Effect effect_of(const Problem& problem, const CriticalOnset& onset) {
  Effect effect = without_velocities(problem);
  if (effect.kind == Effect::Kind::outside) return effect;
  velocities_of(onset, effect);
  find_lowest(problem, effect);
  return effect;
}

Effect effect_of(const Problem& problem) {
  if (!inadmissible_reasons(problem).empty()) return without_velocities(problem);
  return effect_of(problem, critical_onset(problem));
}

void fields(record::Fields& f, const Effect& effect) {
  f("kind", effect.kind)("frequency", effect.frequency)("amplitude", effect.amplitude);
  f.some("contact_amplitude", effect.contact_amplitude);
  f.some("indentation", effect.indentation).some("sinking_velocity", effect.sinking_velocity);
  f("friction_coefficient", effect.friction_coefficient);
  f.some("mean_normal_force", effect.mean_normal_force);
  f.some("largest_closed_amplitude", effect.largest_closed_amplitude);
  f("opens", effect.opens).some("reasons", effect.reasons);
  f.some("critical_velocity", if_known(effect.critical_velocity));
  f.some("drive_velocity", if_known(effect.drive_velocity));
  f.some("reduced_below", if_known(effect.reduced_below))("simulated", effect.simulated);
  f.some("relative_error_bound", if_known(effect.relative_error_bound));
  f.some("relative_error", if_known(effect.relative_error))
      .some("why_infinite", effect.why_infinite);
  f.some("lowest_friction", effect.lowest).some("why_no_lowest_friction", effect.why_no_lowest);
}

}  // namespace vcrit
