#include "design/explain.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "answers/critical_onset.hpp"
#include "base/constants.hpp"
#include "critical/admissibility.hpp"

namespace vcrit::design {

namespace {

std::string needs_indentation(const DesignQuestion& question, double times) {
  if (question.problem->load)
    return fmt::format(
        "a load of more than {:.6g} N with the amplitude in proportion ({:.4g} times as much)",
        *question.problem->load->value * times, times);
  return fmt::format(
      "an indentation of more than {:.6g} m with the amplitude in proportion ({:.4g} times as "
      "much)",
      *question.problem->indentation.value * times, times);
}

double omega_of(const DesignQuestion& question) {
  return *question.problem->angular_frequency.value;
}

std::string reach_of(const Failure& f) {
  const Sought sought = f.question.sought;
  return fmt::format("{} from {:.6g} to {:.6g} {}", to_text(sought), f.range.from, f.range.to,
                     unit_of(sought));
}

std::string searched(const Failure& f) {
  std::string text = fmt::format("searched: {}, {} steady states", reach_of(f), f.evaluations);
  if (f.unanswered > 0)
    text +=
        fmt::format(", {} of them not found, the first because: {}", f.unanswered, f.first_reason);
  return text;
}

// What lies before the first place that is known to reach the ratio may reach it, too.
std::string uncertain(const Failure& f) {
  const bool largest = is_largest(f.question.sought);
  return fmt::format(
      "a friction ratio of {} is reached at {:.16g} {}, but whether that is the {} {} is not "
      "known: "
      "{}; give a range (`from`, `to`) without the others",
      f.question.friction_ratio, *f.reached_at, unit_of(f.question.sought),
      largest ? "largest" : "smallest", to_text(f.question.sought), searched(f));
}

std::string least_found(const Failure& f) {
  if (!f.least) return fmt::format("no steady state was found ({})", searched(f));
  return fmt::format("the least that was found is {:.6g}, at {:.6g} {} ({})", *f.least, f.least_at,
                     unit_of(f.question.sought), searched(f));
}

// v* over the largest admissible amplitude, which the indentation bounds.
std::string too_fast_for_amplitudes(const Failure& f) {
  const double most = f.contact.largest_amplitude(omega_of(f.question));
  const double limit = f.range.largest_velocity;
  const bool all = f.range.to > 0.9 * most;
  std::string text = fmt::format(
      "at {:.6g} m/s friction stays full at every {} amplitude: at {:.6g} m it is reduced up to "
      "{:.6g} m/s only",
      f.question.velocity, all ? "admissible" : "searched", f.range.to, limit);
  if (!all) return text + fmt::format("; amplitudes are admissible below {:.6g} m", most);
  text += fmt::format(" (beyond {:.6g} m the contact opens)", most);
  if (!(limit > 0)) return text + ": this frequency is an antiresonance";
  return text + fmt::format(". It takes a velocity below that, or {}",
                            needs_indentation(f.question, f.question.velocity / limit));
}

// The system is homogeneous: indentation, amplitude and speed times one number leave the ratio.
std::string ratio_over_amplitudes(const Failure& f) {
  const double most = f.contact.largest_amplitude(omega_of(f.question));
  std::string text = fmt::format("no {} amplitude reaches a friction ratio of {} at {:.6g} m/s: {}",
                                 f.range.to > 0.9 * most ? "admissible" : "searched",
                                 f.question.friction_ratio, f.question.velocity, least_found(f));
  DesignQuestion slower{with_amplitude(f.question.problem, f.range.to),
                        Sought::velocity,
                        f.question.friction_ratio,
                        0,
                        {},
                        {},
                        f.question.samples};
  try {
    const double velocity = solve(slower).value;
    text += fmt::format(". At an amplitude of {:.6g} m it takes a velocity of at most {:.6g} m/s",
                        f.range.to, velocity);
    if (f.range.to > 0.9 * most)
      text += ", or " + needs_indentation(f.question, f.question.velocity / velocity);
  } catch (const ModelError&) {
    text += fmt::format(". At an amplitude of {:.6g} m no velocity reaches it either", f.range.to);
  }
  return text;
}

std::string too_fast_for_frequencies(const Failure& f) {
  const double limit = f.range.largest_velocity;
  const Problem there = with_angular_frequency(f.question.problem, two_pi * f.range.largest_at);
  const double amplitude = *there->amplitude.value * (f.question.velocity - creep_velocity(there)) /
                           quick_onset(there, two_pi * f.range.largest_at);
  const double most = f.contact.largest_amplitude(two_pi * f.range.largest_at);
  std::string text = fmt::format(
      "at {:.6g} m/s friction stays full at every searched {}: it is reduced up to {:.6g} m/s at "
      "most, at {:.6g} Hz. It takes a velocity below that, or an amplitude above {:.6g} m there",
      f.question.velocity, reach_of(f), limit, f.range.largest_at, amplitude);
  if (amplitude >= most)
    text +=
        fmt::format(", which opens the contact: the amplitude is admissible below {:.6g} m", most);
  return text;
}

std::string ratio_over_frequencies(const Failure& f) {
  std::string text = fmt::format("no frequency reaches a friction ratio of {} at {:.6g} m/s: {}",
                                 f.question.friction_ratio, f.question.velocity, least_found(f));
  if (!f.least) return text;
  const double omega = two_pi * f.least_at;
  const double limit = 1 - f.contact.oscillating_part(*f.question.problem->amplitude.value, omega);
  text += fmt::format(
      ". Even as the velocity vanishes it tends to {:.6g} there, the least normal force over its "
      "mean",
      limit);
  try {
    const DesignAnswer answer = solve({with_angular_frequency(f.question.problem, omega),
                                       Sought::amplitude,
                                       f.question.friction_ratio,
                                       f.question.velocity,
                                       {},
                                       {},
                                       f.question.samples});
    text += fmt::format(". At that frequency an amplitude of {:.6g} m reaches it", answer.value);
  } catch (const ModelError&) {
    text += ". At that frequency no admissible amplitude reaches it either";
  }
  return text;
}

// A body that swings by itself can take friction below the static limit; so both are told.
std::string ratio_over_velocities(const Failure& f) {
  const double amplitude = *f.question.problem->amplitude.value;
  const double most = f.contact.largest_amplitude(omega_of(f.question));
  const double limit = std::max(0.0, 1 - amplitude / most);
  std::string text = fmt::format("no velocity reaches a friction ratio of {}: {}",
                                 f.question.friction_ratio, least_found(f));
  if (creep_velocity(f.question.problem) > 0) return text;
  text += fmt::format(
      ". As the velocity vanishes it tends to the static limit {:.6g}, the least normal force over "
      "its mean",
      limit);
  if (limit > f.question.friction_ratio)
    text += fmt::format(
        "; for that to be {} the amplitude must be above {:.6g} m (now {:.6g} m, admissible below "
        "{:.6g} m)",
        f.question.friction_ratio, (1 - f.question.friction_ratio) * most, amplitude, most);
  return text;
}

// v* does not depend on the load, the creep of the path is in proportion to it.
std::string too_fast_for_forces(const Failure& f) {
  return fmt::format(
      "at {:.6g} m/s friction stays full at every load: at {:.6g} N it is reduced up to {:.6g} m/s "
      "only. A larger amplitude raises that speed, another load does not",
      f.question.velocity, f.range.to, f.range.largest_velocity);
}

std::string ratio_over_forces(const Failure& f) {
  return fmt::format(
      "no load reaches a friction ratio of {} at {:.6g} m/s: {}. Smaller loads than {:.6g} N open "
      "the contact",
      f.question.friction_ratio, f.question.velocity, least_found(f),
      f.contact.least_force(*f.question.problem->amplitude.value, omega_of(f.question)));
}

}  // namespace

std::string explanation(const Failure& failure) {
  if (failure.reached_at) return uncertain(failure);
  const bool too_fast = failure.range.rows.empty();
  switch (failure.question.sought) {
    case Sought::amplitude:
      return too_fast ? too_fast_for_amplitudes(failure) : ratio_over_amplitudes(failure);
    case Sought::frequency:
      return too_fast ? too_fast_for_frequencies(failure) : ratio_over_frequencies(failure);
    case Sought::velocity:
      return too_fast ? fmt::format(
                            "from {:.6g} m/s on friction is full; it is reduced below "
                            "{:.6g} m/s only",
                            failure.range.from, failure.range.largest_velocity)
                      : ratio_over_velocities(failure);
    case Sought::force:
      return too_fast ? too_fast_for_forces(failure) : ratio_over_forces(failure);
  }
  throw Bug("a failure without an explanation");
}

}  // namespace vcrit::design
