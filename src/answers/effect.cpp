#include "answers/effect.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstdint>

#include "answers/friction.hpp"
#include "answers/ringing.hpp"
#include "base/constants.hpp"
#include "critical/admissibility.hpp"
#include "indenter/friction.hpp"
#include "record/fields.hpp"
#include "rules/rulebook.hpp"
#include "simulation/steady/normal_force.hpp"

namespace vcrit {

namespace {

using rules::Question;

Question motion_question(const Problem& problem) {
  return problem->indenter ? Question::motion_below_indenter : Question::motion;
}

// The stiffness at omega is the force of an amplitude of 1 m.
std::optional<double> largest_closed_amplitude(const Problem& problem) {
  if (!rules::answer(Question::mean_load, problem) ||
      !rules::answer(Question::closed_amplitude, problem))
    return std::nullopt;
  const rules::Facts facts(problem.with({{problem->amplitude.symbol, 1.0}}));
  const long double most = facts.mean_force() / facts.oscillating_force();
  return most > 0 ? std::optional(static_cast<double>(most)) : std::nullopt;
}

std::optional<double> mean_normal_force(const Problem& problem, const Effect& effect) {
  if (problem->indenter || (effect.opens && !rules::answer(Question::motion, problem)))
    return std::nullopt;
  if (effect.opens) return simulation::mean_normal_force(simulation::system_of(problem));
  return static_cast<double>(rules::Facts(problem).mean_force());
}

void operating_point_of(const Problem& problem, Effect& effect) {
  effect.frequency = problem.value(problem->angular_frequency) / two_pi;
  effect.amplitude = problem.value(problem->amplitude);
  effect.indentation = problem.value(problem->indentation);
  effect.friction_coefficient = problem.value(problem->coefficient);
  effect.below_indenter = problem->indenter.has_value();
  effect.largest_closed_amplitude = largest_closed_amplitude(problem);
  effect.opens = problem->separation && opens(problem);
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
  effect.simulated = onset.by == CriticalOnset::By::simulation;
  if (effect.simulated)
    effect.relative_error = onset.relative_error;
  else
    effect.relative_error_bound = onset.relative_error_bound;
  effect.why_infinite = onset.reason;
}

// The contact sticks all but the instant at which its normal force is least, and carries mu0 times
// that. Without a body friction never falls with the speed (docs/physics.md), so no speed has less.
LowestFriction limit_at_rest(const Effect& effect) {
  return {std::max(0.0, 1 - effect.amplitude / *effect.largest_closed_amplitude), 0};
}

// A body that swings may take friction below that at some speed.
class FrictionWithBody {
 public:
  FrictionWithBody(const Problem& problem, double full_from)
      : friction_(problem), full_from_(full_from) {}

  /// Throws ModelError where too few states are found.
  LowestFriction lowest(const LowestFriction& at_rest) const {
    std::vector<double> ratios(samples, infinity);
    ratios[0] = at_rest.ratio;
    ask(ratios);
    const auto least = std::min_element(ratios.begin() + 1, ratios.end());
    if (ratios[0] <= *least + negligible) return at_rest;
    const auto place = static_cast<int>(least - ratios.begin());
    return refined({*least, speed(place)}, speed(place - 1), speed(place + 1));
  }

 private:
  static constexpr int samples = 64, most_missing = samples / 4;
  static constexpr double negligible = 1e-9;

  double speed(int place) const { return full_from_ * place / samples; }

  void ask(std::vector<double>& ratios) const {
    std::vector<double> speeds;
    for (int i = 1; i < samples; ++i) speeds.push_back(speed(i));
    int missing = 0;
    std::string why;
    friction_.curve(speeds, [&](std::size_t i, const simulation::PassingPoint& point) {
      if (point.state != nullptr)
        ratios[i + 1] = point.state->friction_ratio;
      else if (missing++ == 0)
        why = point.reason;
    });
    if (missing > most_missing) throw ModelError(why);
  }

  LowestFriction refined(LowestFriction best, double low, double high) const {
    constexpr int bits = 12;
    std::uintmax_t steps = 24;
    const auto ratio = [&](double v) { return friction_.at(v).friction_ratio; };
    try {
      const auto [v, found] = boost::math::tools::brent_find_minima(
          ratio, std::max(low, negligible * high), high, bits, steps);
      if (found < best.ratio) best = {found, v};
    } catch (const ModelError&) {
      // A speed without a steady state nearby: what was found stands.
    }
    return best;
  }

  SteadyFriction friction_;
  double full_from_;
};

LowestFriction lowest_with_body(const Problem& problem, const Effect& effect) {
  constexpr double most_ringing = 1e6;  // beyond, it is far from the limit at speeds of any use
  if (ringing(simulation::system_of(problem)) < most_ringing)
    return FrictionWithBody(problem, effect.reduced_below).lowest(limit_at_rest(effect));
  throw ModelError(
      "the body is in undamped resonance while it sticks, so friction at rest has no known limit");
}

// So slow that friction below an indenter is its limit at rest, to 1e-9.
constexpr double nearly_at_rest = 1e-9;

void lowest_below_indenter(const Problem& problem, Effect& effect) {
  const indenter::Friction found =
      indenter::friction(indenter::HalfSpace(problem), nearly_at_rest * effect.drive_velocity);
  effect.mean_normal_force = found.normal_force;
  effect.lowest = LowestFriction{effect.opens ? 0 : found.ratio, 0};
}

void lowest_of_contact(const Problem& problem, Effect& effect) {
  if (effect.opens)
    effect.lowest = LowestFriction{};
  else if (!problem->mass)
    effect.lowest = limit_at_rest(effect);
  else if (!std::isnan(effect.reduced_below))
    effect.lowest = lowest_with_body(problem, effect);
}

// On a path that creeps it is that of the creep, which is no vibration's work.
void find_lowest(const Problem& problem, Effect& effect) {
  const bool lowers = effect.kind == Effect::Kind::lowers;
  const rules::Answer moves = rules::answer(motion_question(problem), problem);
  if (lowers && !moves) effect.why_no_lowest = moves.reason;
  if (!lowers || !moves || effect.creeps()) return;
  try {
    if (problem->indenter)
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

Effect without_velocities(const Problem& problem) {
  Effect effect;
  operating_point_of(problem, effect);
  effect.reasons = inadmissible_reasons(problem);
  if (!effect.reasons.empty()) effect.kind = Effect::Kind::outside;
  effect.mean_normal_force = mean_normal_force(problem, effect);
  return effect;
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

void fields(record::Fields& f, const LowestFriction& lowest) {
  f("friction_ratio", lowest.ratio)("velocity", lowest.velocity);
}

void fields(record::Fields& f, const Effect& effect) {
  f("kind", effect.kind)("frequency", effect.frequency)("amplitude", effect.amplitude);
  f("indentation", effect.indentation)("friction_coefficient", effect.friction_coefficient);
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
