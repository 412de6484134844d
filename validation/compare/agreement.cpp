#include "compare/agreement.hpp"

#include <fmt/core.h>

#include <cmath>

#include "answers/critical_onset.hpp"
#include "answers/realised_friction.hpp"
#include "base/constants.hpp"
#include "base/free_swings.hpp"
#include "base/rounded.hpp"
#include "compare/border.hpp"
#include "compare/formulas.hpp"
#include "compare/frequency_response.hpp"
#include "compare/friction.hpp"
#include "compare/indented.hpp"
#include "compare/influences.hpp"
#include "compare/method_curves.hpp"
#include "compare/periodic_motion.hpp"
#include "compare/reduced_difference.hpp"
#include "compare/separation.hpp"
#include "compare/steady_cycle.hpp"
#include "compare/values.hpp"
#include "compare/velocity_comparisons.hpp"
#include "critical/admissibility.hpp"
#include "critical/certified.hpp"
#include "critical/conditioning.hpp"
#include "critical/critical_velocity.hpp"
#include "derivation/derivation.hpp"
#include "formula/names.hpp"
#include "problem/variants.hpp"
#include "rules/rulebook.hpp"
#include "simulation/steady/near_resonance.hpp"
#include "simulation/steady/onset.hpp"

namespace vcrit::validation {

namespace {

void derive_all(SceneReport& report, const symbolic::Derivation& derivation) {
  report.formula = shown_velocity(derivation);
  report.facts = shown_facts(derivation);
  report.equation = derivation.equation;
  report.derivation = equations_of(derivation.lines);
  report.derivation.back().right = report.formula.formula;
  report.limits = limits_of(derivation);
}

/// Elastic networks, a rigid drive: the case with a closed form.
bool has_closed_form(const SceneReport& report, const simulation::System& system) {
  const auto elastic = [](const Relaxation& form) {
    return form.damper == 0 && form.branches.empty() && form.equilibrium > 0;
  };
  const Values& values = report.problem.values();
  return !system.opening && !system.drive && !system.masses && elastic(system.contact) &&
         elastic(relaxation_form(report.problem->normal.network(), values));
}

// The same theory as Eq. 24, from the relaxation forms of the networks.
Comparison balanced(const SceneReport& report, const simulation::System& system,
                    const simulation::Onset& threshold) {
  Comparison comparison = velocity_comparison(
      report, "balance", "harmonic balance, as Eq. 24, of the networks in relaxation form");
  comparison.found = threshold.contact_velocity;
  comparison.tolerance = motion_tolerance(report.condition);
  comparison.reason =
      comparison.tolerance > motion_promise
          ? fmt::format("doubles: 32 roundings of 2⁻⁵³, times the condition number {:.3g} here",
                        report.condition)
          : "doubles: leaves six digits to lose near resonance";
  if (system.masses && threshold.uncertainty > 0) {
    comparison.tolerance += threshold.uncertainty / threshold.contact_velocity;
    comparison.reason += fmt::format("; and ±{}, what rounding takes of a drive with masses",
                                     rounded(threshold.uncertainty, "m/s", 2));
  }
  const std::vector<int>& free = report.free_harmonics;
  if (free.size() == 1)
    comparison.detail = fmt::format(
        "the drive swings freely at {} ω: friction is full from Eq. 24 times cos(π/{}) on",
        free.front(), 2 * free.front());
  else if (!free.empty())
    comparison.detail = fmt::format(
        "the drive swings freely at {} harmonics: friction is full from Eq. 24 times {:.4g} on",
        free.size(), sliding_share(free));
  return comparison;
}

// The balance of the structure that moves in place of a table, with v* by the table itself.
Comparison realised(const SceneReport& report, const simulation::Onset& threshold) {
  Comparison comparison = velocity_comparison(
      report, "balance", "harmonic balance of the structure fitted to the drive's table");
  const RealisedVelocity fit = realised_velocity(report.problem);
  comparison.found = threshold.contact_velocity;
  comparison.tolerance = fit.difference / fit.value + motion_tolerance(report.condition);
  comparison.reason = "the error of the fit, and what a straight line between two rows leaves out";
  const auto friction = realised_friction(report.problem, 0.5 * fit.value);
  if (!friction.outside.empty()) comparison.detail = friction.warnings.back();
  return comparison;
}

bool is_measured(const SceneReport& report) { return report.problem->receptance() != nullptr; }

bool by_formula(const SceneReport& report) {
  return !report.separation || report.separation->closed_form;
}

Border border_of(const SceneReport& report, const CriticalOnset& onset) {
  if (!by_formula(report)) return simulated_border(onset);
  Border border{report.velocity_of_doubles, report.velocity_of_doubles + report.creep_velocity,
                report.condition, formula_reference};
  if (!is_measured(report)) return border;
  border.uncertainty = realised_velocity(report.problem).difference;
  border.why = "by which the structure fitted to the table may be off";
  return border;
}

// Speeds just below and above v* are told apart by the v* of what marches: a simulated one is that.
Border border_of_march(const SceneReport& report, const Border& border) {
  if (!is_measured(report) || !by_formula(report)) return border;
  const double fitted = realised_velocity(report.problem).value;
  return {fitted, fitted, report.condition, "Eq. 24 with the structure fitted to the table"};
}

/// evaluated: v* by formula and evaluators.
void compare_border(SceneReport& report, const CriticalOnset& onset,
                    const simulation::System& system, const std::vector<Comparison>& evaluated,
                    const Witnesses& witnesses) {
  const Border border = border_of(report, onset);
  const auto add = [&](const std::optional<Comparison>& comparison) {
    if (comparison) report.comparisons.push_back(*comparison);
  };
  if (!is_speed(border.contact_velocity)) {
    add(compare_stick_without_end(border, system));
    add(compare_march_without_end(border, system));
    return;
  }
  try {
    const simulation::Onset last_stick = simulation::stick_onset(system);
    add(compare_last_stick(border, last_stick));
    add(compare_creep(border, last_stick));
    // Those hold the table itself.
    if (by_formula(report) && !is_measured(report))
      add(compare_evaluators(evaluated, last_stick, border.condition));
  } catch (const ModelError& error) {
    add(not_run(compare_last_stick(border, {}), error.what()));
  }
  add(witnesses.march(border_of_march(report, border), system));
}

void trace_curve(SceneReport& report, const simulation::System& system, double threshold) {
  const double amplitude_ratio = std::abs(system.normal_force_amplitude) / system.mean_normal_force;
  const bool closed_form = has_closed_form(report, system);
  for (const double ratio : curve_ratios()) {
    report.curve.push_back(friction_at(system, threshold, ratio));
    if (closed_form) report.curve.back().closed_form = elastic_friction(amplitude_ratio, ratio);
  }
  report.comparisons.push_back(compare_starts(report.curve));
  if (closed_form) report.comparisons.push_back(compare_closed_form(report.curve));
}

// Why no march in time tells anything of v*; empty where one does.
std::string why_no_march(const SceneReport& report) {
  if (const auto moves = rules::answer(rules::Question::report_simulation, report.problem); !moves)
    return moves.reason;
  if (!report.formula_applies) return {};
  if (!is_speed(report.critical_velocity)) return "v* is infinite or 0: no speed to look for";
  if (!report.problem->rigid() && !leaves_digits(formula_tolerance(report.condition)))
    return lost_digits;
  return {};
}

// v* of these numbers as the program answers it. Nothing where it refuses: then the scene is
// outside the model here, too, for that reason.
std::optional<CriticalOnset> answered_onset(SceneReport& report, const Problem& numbers) {
  if (!report.reasons.empty()) return std::nullopt;
  try {
    return critical_onset(numbers);
  } catch (const ModelError& error) {
    report.reasons.emplace_back(error.what());
    return std::nullopt;
  }
}

// Nothing where v* is 0/0: the reasons say so.
std::optional<Effect> effect_for(const Problem& problem,
                                 const std::optional<CriticalOnset>& onset) {
  try {
    return onset ? effect_of(problem, *onset) : effect_of(problem);
  } catch (const ModelError&) {
    return std::nullopt;
  }
}

/// The curve, and one cycle at half that speed; `ratio` is what the cycle's is of v*, 0 of none.
void trace_with_cycle(SceneReport& report, const simulation::System& system, double drive_velocity,
                      double ratio) {
  trace_curve(report, system, drive_velocity);
  report.cycle = steady_cycle(system, 0.5 * drive_velocity);
  report.cycle->ratio = ratio;
}

/// Friction where v* has no digits left to compare, as with a drive that does not give at all: it
/// may be simulated nevertheless.
void trace_alone(SceneReport& report, const Witnesses& witnesses, double drive_velocity) {
  try {
    const simulation::System system = witnesses.system(report.problem);
    trace_with_cycle(report, system, drive_velocity, 0.5);
  } catch (const ModelError&) {
    report.curve.clear();  // so near a resonance that nothing is
  }
}

void simulate(SceneReport& report, const symbolic::Derivation& derivation,
              const CriticalOnset& onset, const Witnesses& witnesses, const Progress& progress) {
  progress("simulating");
  const std::vector<Comparison> evaluated = report.comparisons;
  Comparison pending = velocity_comparison(report, "simulation", "stick-slip simulation");
  if (const std::string why = why_no_march(report); !why.empty()) {
    report.comparisons.push_back(not_run(pending, why));
    report.comparisons.push_back(compare_periodic_motion(report));
    if (why == lost_digits)
      trace_alone(report, witnesses, report.critical_velocity + report.creep_velocity);
    return;
  }
  // Where no motion can begin there is nothing that could fail.
  bool out_of_reach = !report.problem->indenter;
  try {
    if (report.problem->indenter) return examine_indenter(report, onset, witnesses);
    const simulation::System system = witnesses.system(report.problem);
    out_of_reach = simulation::lost_in_resonance(simulation::Model(system));
    if (report.problem->separation) {
      progress("letting the contact open");
      examine_separation(report, derivation, system, onset);
    }
    if (by_formula(report)) {
      const simulation::Onset threshold = witnesses.balance(system);
      report.comparisons.push_back(is_measured(report) ? realised(report, threshold)
                                                       : balanced(report, system, threshold));
    }
    progress("looking for the last stick");
    compare_border(report, onset, system, evaluated, witnesses);
    if (is_measured(report) && by_formula(report))
      report.comparisons.push_back(compare_periodic_motion(report));
    const double finite = by_formula(report) ? report.critical_velocity + report.creep_velocity
                                             : onset.drive_velocity;
    const double drive_velocity =
        std::isfinite(finite) ? finite : unit_of_speed(report.problem) + report.creep_velocity;
    pending = velocity_comparison(report, "curve", "friction curve");
    progress("tracing the friction curve");
    trace_with_cycle(report, system, drive_velocity, std::isfinite(finite) ? 0.5 : 0);
    progress("simulating by other methods");
    report.methods = witnesses.curves(system, drive_velocity);
    report.reduced_model = reduced_model(report.problem);
  } catch (const ModelError& error) {
    report.comparisons.push_back((out_of_reach ? not_run : broken)(pending, error.what()));
  }
}

}  // namespace

Witnesses own_witnesses() {
  return {[](const Problem& problem) { return certified_critical_velocity(problem); },
          [](const Problem& problem) { return critical_velocity(problem); },
          [](const Problem& problem) { return simulation::system_of(problem); },
          [](const Problem& problem) { return indenter::HalfSpace(problem); },
          [](const simulation::System& system) { return simulation::sliding_threshold(system); },
          compare_march,
          method_curves};
}

SceneReport agree(Driver& driver, const symbolic::Derivation& formula, const Progress& progress,
                  const Witnesses& witnesses) {
  const Problem& typed = driver.derivation().problem;
  const Problem problem = as_doubles(typed);
  const symbolic::NamesOfScene names(problem);
  const Values& values = problem.values();
  SceneReport report(problem);
  report.reasons = inadmissible_reasons(problem);
  // What is said of the scene is what vcrit eval says: of the numbers as typed. Next to a resonance
  // v* of the doubles, which is finite there, may be another one. Motions have doubles alone.
  const bool by_formula =
      report.reasons.empty() && rules::answer(rules::Question::formula, problem);
  const Problem& told = by_formula ? typed : problem;
  const std::optional<CriticalOnset> onset = answered_onset(report, told);
  report.formula_applies = report.reasons.empty() && by_formula;
  const CertifiedVelocity certified = witnesses.certified(typed);
  report.velocity_of_doubles = witnesses.certified(problem).value;
  report.critical_velocity = certified.value;
  report.relative_error_bound = certified.relative_error_bound;
  report.infinite_reason = certified.reason;
  report.condition = condition_number(problem, values);
  if (report.formula_applies) report.free_harmonics = free_harmonics(problem);
  report.sliding_from = report.critical_velocity * sliding_share(report.free_harmonics);
  report.creep_velocity = creep_velocity(problem);

  report.values = value_lines(problem);
  report.normal_force = normal_force(problem);
  report.effect = effect_for(told, onset);
  // Of v* = 0 and infinity there is no per cent.
  if (onset && is_speed(onset->contact_velocity))
    report.influences = influences(problem, report.values);

  progress("deriving the formula");
  derive_all(report, formula);
  report.comparisons.push_back(
      in_doubles(report, "formula", "Eq. 24 in doubles", witnesses.formula(problem)));
  report.comparisons.push_back(derived_comparison(report, formula, values));
  report.response = frequency_response(driver.derivation());
  progress("compiling all evaluators");
  compare_generated(report, driver, values);

  if (onset) simulate(report, driver.derivation(), *onset, witnesses, progress);
  return report;
}

}  // namespace vcrit::validation
