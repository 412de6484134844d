#include "friction_words.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "answers/effect_words.hpp"
#include "base/errors.hpp"
#include "options.hpp"
#include "rules/kinds.hpp"

namespace vcrit::app {

namespace {

// A smaller reduction counts as none: time-stepping methods are off by as much.
constexpr double negligible_reduction = 1e-9;

std::string ratio_words(const Speed& speed, int digits) {
  if (speed.critical == 0) return "where v* is 0";
  if (std::isinf(speed.critical)) return "where v* is infinite";
  if (std::isinf(speed.ratio)) return "more than 10³⁰⁸ times v*";
  return fmt::format("{} times v*", rounded(speed.ratio, "", digits));
}

std::string what_vibration_does(const Speed& speed, const FrictionFound& found, int digits) {
  const std::string at =
      fmt::format("At {}, {}", rounded(speed.velocity, "m/s", digits), ratio_words(speed, digits));
  const double reduction = 1 - found.ratio;
  if (reduction <= std::max(found.error, negligible_reduction))
    return at + ": no reduction there, friction is full.";
  return fmt::format("{}, friction is {} lower.", at, whole_percent(reduction));
}

int digits_of(double ratio, double error, int digits) {
  const double relative = error / ratio;
  if (!(relative > 0.5e-15) || !std::isfinite(relative)) return digits;
  return std::clamp(static_cast<int>(-std::log10(2 * relative)), 1, digits);
}

}  // namespace

std::string friction_ratio_words(double ratio, double error, int digits) {
  const std::string text =
      rounded(ratio, "", digits_of(ratio, error, digits)) + " of the sliding value";
  return error > 0 ? fmt::format("{} (error about {:.1g})", text, error) : text;
}

std::string regime_words(simulation::Regime regime, bool below_indenter) {
  const std::string what = below_indenter ? "the rim" : "the contact";
  using simulation::Regime;
  switch (regime) {
    case Regime::sliding:
      return "continuous sliding";
    case Regime::stick_slip:
      return "stick-slip: the contact sticks for a part of every cycle";
    case Regime::stick_slip_backslip:
      return "stick-slip with reverse slip";
    case Regime::stick:
      return "sticking: the drive creeps, and the contact never slips";
    case Regime::sliding_separated:
      return "sliding whenever it is closed; " + what + " opens in every cycle";
    case Regime::stick_slip_separated:
      return "stick-slip, and " + what + " opens in every cycle";
    case Regime::stick_slip_backslip_separated:
      return "stick-slip with reverse slip, and " + what + " opens in every cycle";
  }
  throw Bug("a regime without words");
}

void print_friction(const Problem& problem, const Speed& speed, const FrictionFound& found,
                    int digits) {
  const double mu0 = problem.value(problem->coefficient), full = mu0 * found.mean_normal_force;
  const int left = digits_of(found.ratio, found.error, digits);
  if (!problem->source->title.empty()) fmt::print("{}\n", problem->source->title);
  fmt::print("{}\n\n{}\n", conditions(without_velocities(problem), digits),
             what_vibration_does(speed, found, digits));
  print_row("friction ratio", friction_ratio_words(found.ratio, found.error, digits));
  print_row("mean friction",
            fmt::format("{} of {} without vibration", rounded(found.ratio * full, "N", left),
                        rounded(full, "N", digits)));
  print_row("mean normal force", rounded(found.mean_normal_force, "N", digits));
  print_row("coefficient", fmt::format("{} (mu0 = {})", rounded(found.ratio * mu0, "", left),
                                       rounded(mu0, "", digits)));
  print_row("motion", regime_words(found.regime, rules::cells_move(problem)));
}

}  // namespace vcrit::app
