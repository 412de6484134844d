// vcrit critical: v* by the formula against v* by simulation.
#include <fmt/core.h>
#include <CLI/App.hpp>

#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "answers/critical_onset.hpp"
#include "answers/realised_friction.hpp"
#include "base/rounded.hpp"
#include "commands.hpp"
#include "critical/conditioning.hpp"
#include "indenter/friction.hpp"
#include "options.hpp"
#include "record/fields.hpp"
#include "rules/kinds.hpp"
#include "rules/rulebook.hpp"
#include "simulation/steady/onset.hpp"
#include "stiffness/relaxation.hpp"

namespace vcrit::app {

namespace {

// 0 is no share of 0, where nothing oscillates.
double share_of(double part, double whole) { return part == 0 ? 0 : part / whole; }

// The formula against two independent simulations: the lowest speed of steady sliding
// (`simulated`), and the highest speed at which a motion that starts at rest still sticks.
struct CriticalComparison {
  double formula, condition, simulated;
  double unit = formula;          // what differences are shares of, m/s
  double sliding_from = formula;  // where the formula has a drive that swings freely slide already
  std::optional<double> stick_onset = {};
  std::string missing = {};     // why there is no stick onset
  double uncertainty = 0;       // to either side of it: what rounding leaves open
  double of_drive = 0;          // relative, of v*: what rounding takes of a drive with masses
  double of_fit = 0;            // relative, of v* by a structure fitted to a measured drive's table
  int cells = 0, answered = 0;  // below an indenter: asked for it, and those with a steady state
  std::vector<std::string> warnings = {};

  double difference(double value) const { return apart(value, formula); }
  double tolerance() const { return motion_tolerance(condition) + of_drive + of_fit; }
  double stick_tolerance() const { return tolerance() + share_of(uncertainty, unit); }
  double sliding_difference() const { return apart(simulated, sliding_from); }
  bool agrees() const {
    return sliding_difference() <= tolerance() &&
           (!stick_onset || difference(*stick_onset) <= stick_tolerance());
  }

  friend void fields(record::Fields& f, const CriticalComparison& it) {
    std::optional<double> stick_difference;
    if (it.stick_onset) stick_difference = it.difference(*it.stick_onset);
    f("formula", it.formula)("simulated", it.simulated);
    f.when(it.sliding_from != it.formula, "sliding_from", it.sliding_from);
    f("relative_difference", it.sliding_difference())("stick_onset", it.stick_onset);
    f("stick_onset_difference", stick_difference);
    f("tolerance", it.tolerance())("agree", it.agrees());
    f.when(it.of_fit > 0, "realisation_difference", it.of_fit);
    if (it.answered < it.cells)
      f.group("stick_onset_cells", [&](record::Fields& group) {
        group("asked", it.cells)("with_steady_state", it.answered);
      });
    f.when(it.uncertainty > 0, "stick_onset_tolerance", it.stick_tolerance());
    f.when(!it.stick_onset, "stick_onset_missing", it.missing).some("warnings", it.warnings);
  }

 private:
  double apart(double value, double from) const {
    return value == from ? 0 : std::abs(value - from) / (from == 0 ? unit : from);
  }
};

// The relative change of v* with all its numbers together. The condition number of the formula
// would be infinite where an absorber keeps the drive's end still, though v* and the motion lose no
// digit.
double condition_by_derivatives(const Problem& problem) try {
  double sum = 1;
  for (const auto& [symbol, value] : problem.values())
    sum += std::abs(onset_log_derivative(problem, symbol));
  return sum;
} catch (const ModelError&) {
  return std::numeric_limits<double>::infinity();
}

// At an exact antiresonance of the doubles no digit is lost: formula and simulation both give 0.
double condition_of(const Problem& problem, double formula) {
  const double condition = condition_number(problem, problem.values());
  if (formula == 0 && std::isinf(condition)) return 0;
  if (leaves_digits(motion_tolerance(condition))) return condition;
  if (const double exact = condition_by_derivatives(problem);
      leaves_digits(motion_tolerance(exact)))
    return exact;
  throw ModelError(
      fmt::format("the simulator, which works in doubles, has no digit of v* = {}: body and "
                  "drive are too near an undamped resonance or antiresonance: nothing to compare",
                  rounded(formula, "m/s")),
      "vcrit eval gives v* with all digits");
}

// v* of the contact alone, m/s. At an antiresonance the drive's swing takes all of it away: what
// two ways to 0 leave in doubles is roundings of that.
double velocity_of_contact(const simulation::System& system) {
  return system.friction * std::abs(system.normal_force_amplitude) * system.omega /
         std::abs(dynamic_stiffness(system.contact, system.omega));
}

// Sliding of all cells, and the last stick of any.
CriticalComparison below_indenter(const Problem& problem) {
  const indenter::HalfSpace half_space(problem);
  CriticalComparison result{certified_onset(problem).value,
                            condition_number(problem, problem.values()),
                            indenter::sliding_threshold(half_space).contact_velocity};
  try {
    const indenter::LastStick last = indenter::last_stick(half_space);
    result.stick_onset = last.onset.contact_velocity;
    result.uncertainty = last.onset.uncertainty;
    result.cells = last.asked;
    result.answered = last.answered;
  } catch (const ModelError& error) {
    result.missing = error.what();
  }
  return result;
}

CriticalComparison of_one_contact(const Problem& problem) {
  const simulation::System system = simulation::system_of(problem);
  const auto [formula, bound, reason] = certified_onset(problem);
  if (std::isinf(formula)) throw ModelError(reason + ": nothing to compare");
  const double condition = condition_of(problem, formula);
  const simulation::Onset threshold = simulation::sliding_threshold(system);
  CriticalComparison result{formula, condition, threshold.contact_velocity};
  result.sliding_from = formula * sliding_share(free_harmonics(problem));
  if (formula == 0) result.unit = velocity_of_contact(system);
  if (system.masses) result.of_drive = share_of(threshold.uncertainty, result.unit);
  if (problem->receptance() != nullptr)
    result.of_fit = share_of(realised_velocity(problem).difference, result.unit);
  if (formula == 0 && result.unit > 0) {
    result.missing =
        "at an antiresonance sliding is steady at every speed, so no stick is the last";
    return result;
  }
  try {
    const simulation::Onset last = simulation::stick_onset(system);
    result.stick_onset = last.contact_velocity;
    result.uncertainty = last.uncertainty;
  } catch (const ModelError& error) {
    result.missing = error.what();
  }
  return result;
}

CriticalComparison compared(const Problem& problem) {
  rules::require(rules::Question::comparison, problem);
  CriticalComparison result =
      rules::cells_move(problem) ? below_indenter(problem) : of_one_contact(problem);
  result.warnings = problem->source->warnings;
  return result;
}

void print_critical_text(const CriticalComparison& c, int digits) {
  const auto speed = [&](double value) { return rounded(value, "m/s", digits); };
  const auto row = [&](const char* name, double value, double difference, double tolerance,
                       const char* what) {
    print_row(name, fmt::format("{}, {}; off by {:.2g}{}", speed(value), what, difference,
                                difference <= tolerance
                                    ? ""
                                    : fmt::format(", ABOVE THE TOLERANCE {:.2g}", tolerance)));
  };
  fmt::print("Formula and simulation {} on v* = {}.\n", c.agrees() ? "agree" : "DO NOT AGREE",
             speed(c.formula));
  print_row("formula", speed(c.formula) + ", Eq. (24)");
  if (c.sliding_from != c.formula)
    print_row("full friction",
              "from " + speed(c.sliding_from) + " on: the undamped drive swings freely");
  row("simulated", c.simulated, c.sliding_difference(), c.tolerance(),
      "threshold of the linear sliding response, which the formula shares");
  if (c.stick_onset)
    row("stick onset", *c.stick_onset, c.difference(*c.stick_onset), c.stick_tolerance(),
        c.answered < c.cells ? "the last stick of the cells that have a steady state"
                             : "the stick-slip motion from rest sticks up to here (independent)");
  else
    print_row("stick onset", "not found: " + c.missing);
  if (c.of_fit > 0)
    print_row(
        "drive",
        fmt::format("a structure fitted to the table, by which v* may be off by {:.2g}", c.of_fit));
  if (c.answered < c.cells)
    print_row("", fmt::format("{} of {} cells have a steady state", c.answered, c.cells));
}

}  // namespace

void add_critical(CLI::App& program, int& status) {
  struct Options {
    SceneOptions scene;
    int digits = few_digits;
    bool json = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("critical", "Critical velocity: formula against simulation");
  options->scene.add_to(*command);
  add_digits(*command, options->digits);
  command->add_flag("--json", options->json, "print one JSON object");
  command->callback([options, &status] {
    const CriticalComparison comparison = compared(options->scene.read());
    if (!comparison.agrees()) status = 1;
    if (options->json)
      print(record::json_of(comparison));
    else
      print_critical_text(comparison, options->digits);
  });
}

}  // namespace vcrit::app
