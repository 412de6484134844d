#include "agreement.hpp"

#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "compiler.hpp"
#include "critical/admissibility.hpp"
#include "critical/certified.hpp"
#include "critical/critical_velocity.hpp"
#include "evaluators.hpp"
#include "formulas.hpp"
#include "frequency_response.hpp"
#include "friction.hpp"
#include "method_curves.hpp"
#include "network/masses.hpp"
#include "reduced_difference.hpp"
#include "simulation/steady/onset.hpp"
#include "stiffness/dynamic_stiffness.hpp"
#include "values.hpp"

namespace vcrit::validation {

namespace {

constexpr double unit_roundoff = 0x1p-53;

/// The same for a measured drive, of which the table's numbers count.
double measured_condition(const Scene& scene, std::complex<double> contact, double inertia,
                          double omega) {
  const auto [below, above] = bracket(*scene.receptance, omega);
  const double width = above.omega - below.omega;
  const double share = width > 0 ? (omega - below.omega) / width : 0;
  const std::complex<double> first(below.re, below.im), second(above.re, above.im);
  const std::complex<double> receptance = (1 - share) * first + share * second;
  // The shares are differences of angular frequencies: their errors count like those of omega.
  const double steepness = width > 0 ? omega / width * std::abs(second - first) : 0;
  const double error = (1 - share) * std::abs(first) + share * std::abs(second) + steepness;
  const std::complex<double> d = 1.0 - inertia * receptance;
  return inertia * (error + 3 * std::abs(receptance)) * (1 / std::abs(d)) +
         (std::abs(contact) + inertia) * (error + 3 * std::abs(receptance)) /
             std::abs(contact * receptance + d);
}

/// How much relative errors of the scene's numbers can grow on the way to v* (numerics: Tellegen's
/// bound for the networks, and the cancellation near resonance and antiresonance).
double condition_number(const Scene& scene, const Values& values) {
  constexpr double root = std::numbers::sqrt2;
  const double least = 3 + 2 * root;
  if (!has_drive(scene)) return least;
  const double omega = values.at(scene.angular_frequency.symbol);
  const double inertia = scene.mass ? values.at(scene.mass->symbol) * omega * omega : 0;
  const auto [network, factor] = tangential_network(scene);
  const auto contact = factor * dynamic_stiffness(*network, values, omega);
  if (scene.receptance) return least + measured_condition(scene, contact, inertia, omega);
  const auto drive = dynamic_stiffness(*scene.drive, values, omega);
  // Springs and masses cancel inside the drive.
  const double loss = has_masses(*scene.drive) ? sensitivity(reduce(*scene.drive), values, omega)
                                               : root * std::abs(drive);
  const double d = std::abs(drive - inertia), n = std::abs(contact + drive - inertia);
  return least + (loss + 3 * inertia) / d + (root * std::abs(contact) + loss + 3 * inertia) / n;
}

/// A comparison of a velocity with the certified one, still without its value.
Comparison velocity_comparison(const SceneReport& report, const char* key, const char* name) {
  Comparison comparison;
  comparison.key = key;
  comparison.name = name;
  comparison.reference = "Eq. 24, certified";
  comparison.unit = "m/s";
  comparison.expected = report.critical_velocity;
  return comparison;
}

Comparison not_run(Comparison comparison, const std::string& why) {
  comparison.not_run = true;
  comparison.detail = why;
  return comparison;
}

Comparison broken(Comparison comparison, const std::string& why) {
  comparison.broken = true;
  comparison.detail = why;
  return comparison;
}

/// Evaluations in doubles: 32 rounding errors of the inputs, each grown by the condition number.
Comparison in_doubles(const SceneReport& report, const char* key, const char* name, double found) {
  Comparison comparison = velocity_comparison(report, key, name);
  comparison.found = found;
  comparison.tolerance = 32 * unit_roundoff * report.condition;
  comparison.reason =
      fmt::format("doubles: 32 roundings of 2⁻⁵³, times the condition number {:.3g} of Eq. 24 here",
                  report.condition);
  if (std::isfinite(report.condition)) return comparison;
  return not_run(comparison, "exactly at (anti)resonance doubles promise nothing");
}

/// A speed that something can move at: not at an exact resonance or antiresonance.
bool is_speed(double velocity) { return std::isfinite(velocity) && velocity > 0; }

void compare_derived(SceneReport& report, const symbolic::Derivation& derivation,
                     const Values& values) {
  Comparison comparison = velocity_comparison(report, "derived", "derived formula, 50 digits");
  comparison.tolerance = unit_roundoff * (2 + report.condition);
  comparison.reason = fmt::format(
      "each is rounded once; a decimal ratio is exact in one and a double in the other: one more, "
      "times the condition number {:.3g}",
      report.condition);
  if (!is_speed(report.critical_velocity)) {
    report.comparisons.push_back(not_run(comparison, "v* is infinite or 0: no relative error"));
    return;
  }
  try {
    comparison.found = derived_velocity(report.scene, derivation, values);
    report.comparisons.push_back(comparison);
  } catch (const std::exception& error) {
    report.comparisons.push_back(broken(comparison, error.what()));
  }
}

Comparison certified_by_generated(const SceneReport& report, const GeneratedVelocities& generated) {
  Comparison comparison = in_doubles(report, "generated_certified",
                                     "generated evaluator, certified", generated.certified);
  comparison.tolerance = generated.certified_bound + unit_roundoff;
  comparison.reason = fmt::format("its own bound, {:.2g}, and one rounding of the reference",
                                  generated.certified_bound);
  if (std::isfinite(generated.certified_bound)) return comparison;
  return not_run(comparison, "it gives no bound here");
}

void add_generated(SceneReport& report, const GeneratedVelocities& generated) {
  const auto add = [&](const char* key, const char* name, double found) {
    report.comparisons.push_back(in_doubles(report, key, name, found));
  };
  add("generated", "generated evaluator", generated.accurate);
  add("generated_batch", "generated evaluator, batch call", generated.batch);
  add("generated_fast", "generated evaluator, fast grade", generated.fast);
  report.comparisons.push_back(certified_by_generated(report, generated));
}

void compare_generated(SceneReport& report, const symbolic::Derivation& derivation,
                       const Values& values) {
  const Comparison plain = in_doubles(report, "generated", "generated evaluator", 0);
  const auto compiler = find_compiler();
  if (!compiler) {
    report.comparisons.push_back(not_run(plain, "no C++ compiler found"));
    return;
  }
  try {
    const PrivateFolder folder;
    report.compiler = describe_compiler(*compiler, folder.path());
    add_generated(report,
                  generated_velocities(report.scene, derivation, values, *compiler, folder.path()));
  } catch (const ModelError& error) {
    report.comparisons.push_back(not_run(plain, error.what()));
  } catch (const std::runtime_error& error) {
    report.comparisons.push_back(broken(plain, error.what()));
  }
}

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
  return !system.drive && elastic(system.contact) &&
         elastic(relaxation_form(report.scene.normal, values));
}

Comparison simulated_velocity(const SceneReport& report, const simulation::Onset& threshold) {
  Comparison comparison = velocity_comparison(report, "simulation", "stick-slip simulation");
  comparison.found = threshold.contact_velocity;
  comparison.tolerance = 1e-9;
  comparison.reason = "motion in closed form, in doubles: leaves six digits to lose near resonance";
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
  report.comparisons.push_back(compare_pure_sliding(report.curve));
  if (closed_form) report.comparisons.push_back(compare_closed_form(report.curve));
}

void simulate(SceneReport& report, const Progress& progress) {
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
    const simulation::System system = simulation::system_of(report.scene);
    const auto threshold = simulation::sliding_threshold(system);
    report.comparisons.push_back(simulated_velocity(report, threshold));
    if (report.creep_velocity > 0) report.comparisons.push_back(simulated_creep(report, threshold));
    pending = velocity_comparison(report, "curve", "friction curve");
    progress("tracing the friction curve");
    const double drive_velocity = report.critical_velocity + report.creep_velocity;
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

SceneReport agree(const Scene& scene, const Progress& progress) {
  const Values values = values_of(scene);
  SceneReport report;
  report.scene = scene;
  report.reasons = inadmissible_reasons(scene);
  const CertifiedVelocity certified = certified_critical_velocity(scene);
  report.critical_velocity = certified.value;
  report.relative_error_bound = certified.relative_error_bound;
  report.infinite_reason = certified.reason;
  report.condition = condition_number(scene, values);
  report.creep_velocity = creep_velocity(scene);

  report.values = value_lines(scene);

  progress("deriving the formula");
  const symbolic::Derivation derivation = symbolic::derive(scene);
  derive_all(report, derivation);
  report.comparisons.push_back(
      in_doubles(report, "formula", "Eq. 24 in doubles", critical_velocity(scene)));
  compare_derived(report, derivation, values);
  report.response = frequency_response(scene);
  progress("compiling the generated evaluator");
  compare_generated(report, derivation, values);

  if (report.reasons.empty()) simulate(report, progress);
  return report;
}

}  // namespace vcrit::validation
