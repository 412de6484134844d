#include "answers/effect_words.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace vcrit {

namespace {

constexpr const char* speed_unit = "m/s";

// An error of half a last place leaves all of them.
int digits_left(const Effect& effect, int digits) {
  if (!effect.simulated || !(effect.relative_error > 0.5e-15)) return digits;
  return std::clamp(static_cast<int>(-std::log10(2 * effect.relative_error)), 1, digits);
}

std::string speed(const Effect& effect, double value, int digits) {
  return rounded(value, speed_unit, digits_left(effect, digits));
}

std::string up_to_where(const Effect& effect, int digits) {
  const bool known = !std::isnan(effect.reduced_below);
  const double border = known ? effect.reduced_below : effect.drive_velocity;
  return fmt::format("{}below {}{}", known ? "" : "at most ",
                     effect.creeps() ? "a drive speed of " : "", speed(effect, border, digits));
}

std::string by_how_much(const Effect& effect, int digits) {
  if (effect.creeps())
    return fmt::format("; {} of it is creep.",
                       speed(effect, effect.drive_velocity - effect.critical_velocity, digits));
  if (effect.opens)
    return ". The contact opens in every cycle, so friction falls to zero as the speed does.";
  if (effect.lowest) return fmt::format(", by at most {}.", whole_percent(1 - *effect.lowest));
  if (!effect.why_no_lowest.empty())
    return fmt::format(". By how much is not computed: {}.", effect.why_no_lowest);
  return ".";
}

std::string lowering(const Effect& effect, int digits) {
  const char* by = effect.simulated && !effect.by_phase
                       ? " (by simulation: the formula does not apply once the contact opens)"
                       : "";
  return fmt::format("Vibration lowers friction {}{}{}", up_to_where(effect, digits), by,
                     by_how_much(effect, digits));
}

std::string outside(const Effect& effect, int digits) {
  if (!effect.would_open()) return fmt::format("No answer: {}.", effect.reasons.front());
  return fmt::format(
      "No answer: at this amplitude the contact would open. It stays closed {}. Allow separation "
      "or lower the amplitude.",
      closed_range(effect, digits));
}

std::string without_effect(const Effect& effect, int digits) {
  if (!(effect.friction_coefficient > 0)) return "There is no friction that vibration could lower.";
  if (!(effect.amplitude > 0) && effect.creeps())
    return fmt::format(
        "Without vibration friction is full above a drive speed of {}; below it the path creeps.",
        speed(effect, effect.drive_velocity, digits));
  if (!(effect.amplitude > 0)) return "Without vibration friction is full at every speed.";
  return fmt::format(
      "At {} vibration cannot lower friction: the contact point stands still (antiresonance).",
      rounded(effect.frequency, "Hz", digits));
}

// The bound of an infinite v* of Eq. (24) is 0 but where it is too large a number.
std::string at_all_speeds(const Effect& effect, int digits) {
  const bool resonance = !effect.simulated && effect.relative_error_bound == 0;
  return fmt::format(
      "At {} vibration lowers friction at every speed ({}).",
      rounded(effect.frequency, "Hz", digits),
      resonance ? "undamped resonance; any damping makes v* finite" : effect.why_infinite);
}

std::string amplitude_words(const Effect& effect, int digits) {
  const std::string given = rounded(effect.amplitude, "m", digits) + " amplitude";
  if (!effect.of_vibrator) return given;
  if (!effect.contact_amplitude) return given + " of the vibrator";
  return fmt::format("{} of the vibrator ({} at the contact)", given,
                     rounded(*effect.contact_amplitude, "m", digits));
}

std::string pressed_words(const Effect& effect, int digits) {
  std::string text = fmt::format("{} load", rounded(*effect.mean_normal_force, "N", digits));
  if (effect.sinking_velocity)
    text += fmt::format(", under which the contact sinks at {}",
                        rounded(*effect.sinking_velocity, "m/s", digits));
  if (effect.indentation)
    text += fmt::format(" ({} {})", rounded(std::abs(*effect.indentation), "m", digits),
                        *effect.indentation < 0 ? "mean gap" : "indentation");
  return text;
}

}  // namespace

std::string sentence(const Effect& effect, int digits) {
  switch (effect.kind) {
    case Effect::Kind::lowers:
      return lowering(effect, digits);
    case Effect::Kind::never:
      return without_effect(effect, digits);
    case Effect::Kind::all_speeds:
      return at_all_speeds(effect, digits);
    case Effect::Kind::outside:
      return outside(effect, digits);
  }
  throw Bug("an effect without a sentence");
}

std::string conditions(const Effect& effect, int digits) {
  if (effect.under_load)
    return fmt::format("{}, {}, {}.", rounded(effect.frequency, "Hz", digits),
                       amplitude_words(effect, digits), pressed_words(effect, digits));
  std::string text =
      fmt::format("{}, {}, {} indentation", rounded(effect.frequency, "Hz", digits),
                  amplitude_words(effect, digits), rounded(*effect.indentation, "m", digits));
  if (effect.mean_normal_force)
    text += fmt::format(" ({} mean normal force)", rounded(*effect.mean_normal_force, "N", digits));
  return text + ".";
}

std::string operating_point(const Effect& effect, int digits) {
  std::string text = conditions(effect, digits);
  if (effect.largest_closed_amplitude && effect.kind != Effect::Kind::outside)
    text += fmt::format(" The contact stays closed {}up to {}.",
                        effect.below_indenter ? "at its centre " : "",
                        rounded(*effect.largest_closed_amplitude, "m", digits));
  return text;
}

std::string lowest_friction(const Effect& effect, int digits) {
  if (!effect.lowest) return {};
  return fmt::format("{} of the sliding value (at rest)", rounded(*effect.lowest, "", digits));
}

std::string closed_range(const Effect& effect, int digits) {
  if (!effect.largest_closed_amplitude) return {};
  return fmt::format("{}up to {} (now {})", effect.below_indenter ? "at its centre " : "",
                     rounded(*effect.largest_closed_amplitude, "m", digits),
                     rounded(effect.amplitude, "m", digits));
}

std::string rounding_error(const Effect& effect) {
  const double error = effect.simulated ? effect.relative_error : effect.relative_error_bound;
  if (!(error > 0) || !std::isfinite(error)) return {};
  return fmt::format("{} {:.2g}", effect.simulated ? "about" : "below", error);
}

std::string critical_velocity_in_words(const Effect& effect, int digits) {
  return speed(effect, effect.critical_velocity, digits);
}

std::string failed_checks(std::size_t failed, std::size_t made) {
  return fmt::format("Do not use these numbers: {} of {} checks failed.", failed, made);
}

}  // namespace vcrit
