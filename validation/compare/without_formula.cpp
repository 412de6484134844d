#include "compare/without_formula.hpp"

#include <algorithm>
#include <cmath>

#include "answers/critical_onset.hpp"
#include "answers/friction.hpp"
#include "compare/friction.hpp"
#include "compare/influences.hpp"
#include "compare/values.hpp"
#include "compare/velocity_comparisons.hpp"
#include "critical/admissibility.hpp"

namespace vcrit::validation {

namespace {

void trace_friction(SceneReport& report, double speed) {
  const SteadyFriction friction(report.problem);
  std::vector<double> velocities;
  for (const double ratio : curve_ratios()) velocities.push_back(ratio * speed);
  friction.curve(velocities, [&](std::size_t i, const simulation::PassingPoint& point) {
    if (point.state == nullptr) return;
    const simulation::SteadyState& state = *point.state;
    report.curve.push_back({curve_ratios()[i],
                            velocities[i],
                            state.friction_ratio,
                            state.friction_ratio,
                            state.friction_ratio_error,
                            to_text(state.regime),
                            {}});
  });
}

// By docs/physics.md; whatever the contact, the body and its drive.
Comparison compare_rise(const SceneReport& report) {
  Comparison comparison;
  comparison.key = "rise";
  comparison.name = "friction never falls with the speed";
  comparison.reference = "energy of the difference of two motions";
  comparison.measure = Comparison::Measure::absolute;
  comparison.reason = "the errors of both friction ratios";
  for (std::size_t i = 0; i + 1 < report.curve.size(); ++i) {
    const CurvePoint &slow = report.curve[i], &fast = report.curve[i + 1];
    comparison.found = std::max(comparison.found, slow.from_sliding - fast.from_sliding);
    comparison.tolerance = std::max(comparison.tolerance, slow.error + fast.error);
  }
  return comparison;
}

Comparison no_formula_to_compare(const std::string& why) {
  Comparison comparison;
  comparison.key = "formula";
  comparison.name = "formula of v*";
  comparison.reference = "motion";
  comparison.unit = "m/s";
  return not_run(comparison, why);
}

}  // namespace

SceneReport report_without_formula(const Problem& problem, const std::string& why) {
  SceneReport report(problem);
  report.failure = why;
  report.reasons = inadmissible_reasons(problem);
  report.values = value_lines(problem);
  report.comparisons.push_back(no_formula_to_compare(why));
  try {
    const CriticalOnset onset = critical_onset(problem);
    report.effect = effect_of(problem, onset);
    report.influences = influences(problem, report.values);
    const bool finite = onset.drive_velocity > 0 && std::isfinite(onset.drive_velocity);
    if (!report.reasons.empty() || !finite) return report;
    trace_friction(report, onset.drive_velocity);
    report.comparisons.push_back(compare_rise(report));
  } catch (const ModelError& error) {
    report.failure = error.what();
  }
  return report;
}

}  // namespace vcrit::validation
