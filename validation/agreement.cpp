#include "agreement.hpp"

#include <fmt/core.h>

#include <cmath>

#include "base/constants.hpp"
#include "conditioning.hpp"
#include "critical/admissibility.hpp"
#include "critical/certified.hpp"
#include "critical/critical_velocity.hpp"
#include "derivation/derivation.hpp"
#include "explorer.hpp"
#include "formula/names.hpp"
#include "formulas.hpp"
#include "frequency_response.hpp"
#include "friction.hpp"
#include "indented.hpp"
#include "method_curves.hpp"
#include "network/masses.hpp"
#include "onset/formula_scope.hpp"
#include "parting.hpp"
#include "reduced_difference.hpp"
#include "simulation/steady/onset.hpp"
#include "values.hpp"
#include "velocity_comparisons.hpp"

namespace vcrit::validation {

namespace {

void derive_all(SceneReport& report, const symbolic::Derivation& derivation) {
  report.formula = formula_of(derivation.critical_velocity);
  report.equation = derivation.equation;
  report.definitions = equations_of(derivation.definitions);
  report.derivation = equations_of(derivation.lines);
  report.limits = limits_of(report.scene);
}

/// Elastic networks, a rigid drive: the case with a closed form.
bool has_closed_form(const SceneReport& report, const simulation::System& system) {
  const auto elastic = [](const Relaxation& form) {
    return form.damper == 0 && form.branches.empty() && form.equilibrium > 0;
  };
  const Values values = values_of(report.scene);
  return !system.opening && !system.drive && elastic(system.contact) &&
         elastic(relaxation_form(report.scene.normal, values));
}

Comparison simulated_velocity(const SceneReport& report, const simulation::Onset& threshold) {
  Comparison comparison = velocity_comparison(report, "simulation", "stick-slip simulation");
  comparison.found = threshold.contact_velocity;
  comparison.tolerance = 1e-9;
  comparison.reason = "motion in closed form, in doubles: leaves six digits to lose near resonance";
  if (const int n = report.free_harmonic; n > 1) {
    comparison.expected *= std::cos(pi / (2 * n));
    comparison.reference =
        fmt::format("Eq. 24 times cos(π/{}), as the drive swings freely at {} ω", 2 * n, n);
  }
  return comparison;
}

Comparison simulated_creep(const SceneReport& report, const simulation::Onset& threshold) {
  Comparison comparison = simulated_velocity(report, threshold);
  comparison.key = "creep";
  comparison.name = "speed of the far end when pure sliding begins, by simulation";
  comparison.reference = "v* and creep under the mean friction force";
  comparison.expected = report.critical_velocity + report.creep_velocity;
  comparison.found = threshold.drive_velocity;
  return comparison;
}

void trace_curve(SceneReport& report, const simulation::System& system, double threshold) {
  const double amplitude_ratio = std::abs(system.normal_force_amplitude) / system.mean_normal_force;
  const bool closed_form = has_closed_form(report, system);
  for (const double ratio : curve_ratios()) {
    report.curve.push_back(friction_at(system, threshold, ratio));
    if (closed_form) report.curve.back().closed_form = elastic_friction(amplitude_ratio, ratio);
  }
  report.comparisons.push_back(compare_starts(report.curve));
  if (!report.parting || std::isfinite(report.parting->critical_velocity))
    report.comparisons.push_back(compare_pure_sliding(report.curve));
  if (closed_form) report.comparisons.push_back(compare_closed_form(report.curve));
}

void simulate(SceneReport& report, const Witnesses& witnesses, const Progress& progress) {
  progress("simulating");
  Comparison pending = velocity_comparison(report, "simulation", "stick-slip simulation");
  if (!is_speed(report.critical_velocity)) {
    report.comparisons.push_back(not_run(pending, "v* is infinite or 0: no speed to look for"));
    return;
  }
  const std::optional<Network>& drive = report.scene.drive;
  if (report.scene.receptance || (drive && has_masses(*drive))) {
    report.comparisons.push_back(
        not_run(pending, "the simulator knows one body, under a network of springs and dampers"));
    return;
  }
  try {
    if (report.scene.indenter) return examine_indenter(report);
    const simulation::System system = witnesses.system(report.scene);
    report.free_harmonic = system.opening ? 0 : simulation::free_harmonic(system);
    if (report.scene.separation) {
      progress("letting the surfaces part");
      examine_parting(report, system);
    }
    const bool closed_form = !report.parting || report.parting->closed_form;
    double drive_velocity = report.critical_velocity + report.creep_velocity;
    if (closed_form) {
      const auto threshold = simulation::sliding_threshold(system);
      report.comparisons.push_back(simulated_velocity(report, threshold));
      if (report.creep_velocity > 0)
        report.comparisons.push_back(simulated_creep(report, threshold));
    } else if (const double found = report.parting->drive_velocity; std::isfinite(found)) {
      drive_velocity = found;
    }
    pending = velocity_comparison(report, "curve", "friction curve");
    progress("tracing the friction curve");
    trace_curve(report, system, drive_velocity);
    report.cycle = steady_cycle(system, drive_velocity, 0.5);
    progress("simulating by other methods");
    report.methods = method_curves(system, drive_velocity);
    report.reduced_model = reduced_model(report.scene);
  } catch (const ModelError& error) {
    report.comparisons.push_back(broken(pending, error.what()));
  }
}

}  // namespace

Witnesses own_witnesses() {
  return {[](const Scene& scene) { return critical_velocity(scene); },
          [](const Scene& scene) { return symbolic::derive(scene); },
          [](const Scene& scene) { return simulation::system_of(scene); }};
}

SceneReport agree(const Scene& scene, Driver& driver, const Progress& progress,
                  const Witnesses& witnesses) {
  const symbolic::NamesOfScene names(scene);
  const Values values = values_of(scene);
  SceneReport report;
  report.scene = scene;
  report.reasons = inadmissible_reasons(scene);
  report.formula_applies = report.reasons.empty() && formula_holds(scene);
  const CertifiedVelocity certified = certified_critical_velocity(scene);
  report.critical_velocity = certified.value;
  report.relative_error_bound = certified.relative_error_bound;
  report.infinite_reason = certified.reason;
  report.condition = condition_number(scene, values);
  report.creep_velocity = creep_velocity(scene);

  report.values = value_lines(scene);

  progress("deriving the formula");
  const symbolic::Derivation derivation = witnesses.derivation(scene);
  derive_all(report, derivation);
  report.comparisons.push_back(
      in_doubles(report, "formula", "Eq. 24 in doubles", witnesses.formula(scene)));
  report.comparisons.push_back(derived_comparison(report, derivation, values));
  report.response = frequency_response(scene);
  progress("compiling all evaluators");
  compare_generated(report, driver, values);

  if (report.reasons.empty()) simulate(report, witnesses, progress);
  progress("preparing the explorer");
  report.explorer = explorer(scene, derivation, report.values);
  return report;
}

}  // namespace vcrit::validation
