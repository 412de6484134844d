#include "design/explain.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "answers/critical_onset.hpp"
#include "base/constants.hpp"
#include "base/rounded.hpp"
#include "critical/admissibility.hpp"
#include "design/rows_below_indenter.hpp"
#include "rules/kinds.hpp"

namespace vcrit::design {

namespace {

std::string needs_indentation(const DesignQuestion& question, double times) {
  const std::string more =
      "with the amplitude in proportion (" + rounded(times, "") + " times as much)";
  if (question.problem->load)
    return fmt::format("a load of more than {} {}",
                       rounded_up(*question.problem->load->value * times, "N"), more);
  return fmt::format("an indentation of more than {} {}",
                     rounded_up(*question.problem->indentation.value * times, "m"), more);
}

double omega_of(const DesignQuestion& question) {
  return *question.problem->angular_frequency.value;
}

std::string sought_words(const Failure& f, double value, int digits = few_digits) {
  return rounded(value, unit_of(f.question.sought), digits);
}

std::string speed_words(const DesignQuestion& question) {
  return rounded(question.velocity, "m/s");
}

bool below_indenter(const Failure& f) { return rules::cells_move(f.question.problem); }

const char* pressed_by(const Failure& f) {
  return f.question.problem->load ? "load" : "indentation";
}

// Where v* left no place out.
bool full_everywhere(const Failure& f) {
  return finds_each_onset(f.question.problem) && f.least && !(*f.least < 1);
}

std::string reach_of(const Failure& f) {
  return fmt::format("{} from {} to {}", to_text(f.question.sought), sought_words(f, f.range.from),
                     sought_words(f, f.range.to));
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
      "a friction ratio of {} is reached at {}, but whether that is the {} {} is not known: {}; "
      "give a range (`from`, `to`) without the others",
      f.question.friction_ratio, sought_words(f, *f.reached_at, all_digits),
      largest ? "largest" : "smallest", to_text(f.question.sought), searched(f));
}

std::string least_found(const Failure& f) {
  if (!f.least) return fmt::format("no steady state was found ({})", searched(f));
  return fmt::format("the lowest ratio found is {}, at {} ({})", rounded(*f.least, ""),
                     sought_words(f, f.least_at), searched(f));
}

// v* over the largest admissible amplitude, which the indentation bounds.
std::string too_fast_for_amplitudes(const Failure& f) {
  const double most = f.contact.largest_amplitude(omega_of(f.question));
  const double limit = f.range.largest_velocity;
  const bool all = f.range.to > 0.9 * most;
  const auto [speed, limit_words] = rounded_apart(f.question.velocity, limit, "m/s");
  std::string text = fmt::format(
      "at {} friction stays full at every {} amplitude: at {} it is reduced up to {} only", speed,
      all ? "admissible" : "searched", rounded(f.range.to, "m"), limit_words);
  const std::string most_words = rounded_down(most, "m");
  if (!all) return text + fmt::format("; amplitudes are admissible below {}", most_words);
  text += fmt::format(" (beyond {} the contact opens)", most_words);
  if (!(limit > 0)) return text + ": this frequency is an antiresonance";
  text += ". It takes a velocity below that";
  const double times = f.question.velocity / limit;
  if (below_indenter(f) || !std::isfinite(times)) return text;
  return text + ", or " + needs_indentation(f.question, times);
}

// The system is homogeneous: indentation, amplitude and speed times one number leave the ratio.
std::string ratio_over_amplitudes(const Failure& f) {
  const double most = f.contact.largest_amplitude(omega_of(f.question));
  std::string text =
      fmt::format("no {} amplitude reaches a friction ratio of {} at {}: {}",
                  f.range.to > 0.9 * most ? "admissible" : "searched", f.question.friction_ratio,
                  speed_words(f.question), least_found(f));
  DesignQuestion slower{with_amplitude(f.question.problem, f.range.to),
                        Sought::velocity,
                        f.question.friction_ratio,
                        0,
                        {},
                        {},
                        f.question.samples};
  const std::string amplitude = rounded(f.range.to, "m");
  try {
    const double velocity = solve(slower).value;
    text += fmt::format(". At an amplitude of {} it takes a velocity of at most {}", amplitude,
                        rounded_down(velocity, "m/s"));
    const double times = f.question.velocity / velocity;
    if (f.range.to > 0.9 * most && !below_indenter(f) && std::isfinite(times))
      text += ", or " + needs_indentation(f.question, times);
  } catch (const ModelError&) {
    text += fmt::format(". At an amplitude of {} no velocity reaches it either", amplitude);
  }
  return text;
}

std::string too_fast_for_frequencies(const Failure& f) {
  if (finds_each_onset(f.question.problem))
    return fmt::format(
        "at {} friction stays full at every searched frequency ({}). It takes a lower velocity, "
        "or a larger amplitude",
        speed_words(f.question), searched(f));
  const double limit = f.range.largest_velocity;
  const Problem there = with_angular_frequency(f.question.problem, two_pi * f.range.largest_at);
  const double amplitude = *there->amplitude.value * (f.question.velocity - creep_velocity(there)) /
                           quick_onset(there, two_pi * f.range.largest_at);
  const double most = f.contact.largest_amplitude(two_pi * f.range.largest_at);
  const auto [speed, limit_words] = rounded_apart(f.question.velocity, limit, "m/s");
  std::string text = fmt::format(
      "at {} friction stays full at every searched {}: it is reduced up to {} at most, at {}. It "
      "takes a velocity below that",
      speed, reach_of(f), limit_words, rounded(f.range.largest_at, "Hz"));
  if (!std::isfinite(amplitude)) return text;
  text += fmt::format(", or an amplitude above {} there", rounded_up(amplitude, "m"));
  if (amplitude >= most)
    text += fmt::format(", which opens the contact: the amplitude is admissible below {}",
                        rounded_down(most, "m"));
  return text;
}

std::string ratio_over_frequencies(const Failure& f) {
  std::string text =
      fmt::format("no frequency reaches a friction ratio of {} at {}: {}",
                  f.question.friction_ratio, speed_words(f.question), least_found(f));
  if (!f.least) return text;
  const double omega = two_pi * f.least_at;
  const Problem there = with_angular_frequency(f.question.problem, omega);
  if (!below_indenter(f) && !(creep_velocity(there) > 0)) {
    const double limit =
        1 - f.contact.oscillating_part(*f.question.problem->amplitude.value, omega);
    text += fmt::format(
        ". Even as the velocity vanishes it tends to {} there, the least normal force over its "
        "mean",
        rounded(limit, ""));
  }
  try {
    const DesignAnswer answer = solve({there,
                                       Sought::amplitude,
                                       f.question.friction_ratio,
                                       f.question.velocity,
                                       {},
                                       {},
                                       f.question.samples});
    text += fmt::format(". At that frequency an amplitude of {} reaches it",
                        rounded_up(answer.value, "m"));
  } catch (const ModelError&) {
    text += ". At that frequency no admissible amplitude reaches it either";
  }
  return text;
}

// A body that swings by itself can take friction below the static limit; so both are told.
std::string ratio_over_velocities(const Failure& f) {
  if (below_indenter(f))
    return fmt::format(
        "no velocity reaches a friction ratio of {}: {}. Friction never falls with the speed: it "
        "takes a larger amplitude, or a smaller {}",
        f.question.friction_ratio,
        f.range.at_rest
            ? fmt::format(
                  "as the velocity vanishes it tends to {}, the least normal force over its "
                  "mean",
                  rounded(*f.range.at_rest, ""))
            : least_found(f),
        pressed_by(f));
  const double amplitude = *f.question.problem->amplitude.value;
  const double most = f.contact.largest_amplitude(omega_of(f.question));
  const double limit = std::max(0.0, 1 - amplitude / most);
  std::string text = fmt::format("no velocity reaches a friction ratio of {}: {}",
                                 f.question.friction_ratio, least_found(f));
  if (creep_velocity(f.question.problem) > 0) return text;
  text += fmt::format(
      ". As the velocity vanishes it tends to the static limit {}, the least normal force over "
      "its mean",
      rounded(limit, ""));
  if (limit > f.question.friction_ratio) {
    const auto [needed, now] =
        rounded_apart((1 - f.question.friction_ratio) * most, amplitude, "m");
    text += fmt::format(
        "; for that to be {} the amplitude must be above {} (now {}, admissible below {})",
        f.question.friction_ratio, needed, now, rounded_down(most, "m"));
  }
  return text;
}

// v* does not depend on the load, the creep of the path is in proportion to it.
bool creeps_under_load(const Failure& f) {
  return creep_velocity(with_load(f.question.problem, f.range.to)) > 0;
}

std::string too_fast_for_forces(const Failure& f) {
  const bool creeps = creeps_under_load(f);
  if (finds_each_onset(f.question.problem))
    return fmt::format(
        "at {} friction stays full at every searched load ({}). It takes a lower velocity, or a "
        "larger amplitude{}",
        speed_words(f.question), searched(f), creeps ? " or load" : "");
  const auto [speed, limit] = rounded_apart(f.question.velocity, f.range.largest_velocity, "m/s");
  return fmt::format(
      "at {} friction stays full at every {}load: at {} it is reduced up to {} only. A larger "
      "amplitude raises that speed, {}",
      speed, creeps ? "searched " : "", rounded(f.range.to, "N"), limit,
      creeps ? "and so does a larger load, under which the path creeps faster"
             : "another load does not");
}

std::string ratio_over_forces(const Failure& f) {
  const bool creeps = creeps_under_load(f);
  return fmt::format(
      "no {}load reaches a friction ratio of {} at {}: {}. Smaller loads than {} open the "
      "contact{}",
      creeps ? "searched " : "", f.question.friction_ratio, speed_words(f.question), least_found(f),
      rounded_up(f.contact.least_force(*f.question.problem->amplitude.value, omega_of(f.question)),
                 "N"),
      creeps ? "; under larger ones the path creeps faster, and friction falls towards 0" : "");
}

std::string too_fast_for_velocities(const Failure& f) {
  const auto [from, limit] = rounded_apart(f.range.from, f.range.largest_velocity, "m/s");
  return fmt::format("from {} on friction is full; it is reduced below {} only", from, limit);
}

}  // namespace

std::string explanation(const Failure& failure) {
  if (failure.reached_at) return uncertain(failure);
  const bool too_fast =
      (failure.range.rows.empty() && !failure.range.at_rest) || full_everywhere(failure);
  switch (failure.question.sought) {
    case Sought::amplitude:
      return too_fast ? too_fast_for_amplitudes(failure) : ratio_over_amplitudes(failure);
    case Sought::frequency:
      return too_fast ? too_fast_for_frequencies(failure) : ratio_over_frequencies(failure);
    case Sought::velocity:
      return too_fast ? too_fast_for_velocities(failure) : ratio_over_velocities(failure);
    case Sought::force:
      return too_fast ? too_fast_for_forces(failure) : ratio_over_forces(failure);
  }
  throw Bug("a failure without an explanation");
}

}  // namespace vcrit::design
