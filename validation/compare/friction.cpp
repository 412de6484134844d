#include "compare/friction.hpp"

#include <fmt/core.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_roots.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/constants.hpp"
#include "simulation/steady/exact.hpp"

namespace vcrit::validation {

namespace {

using simulation::Start;

// The simulator's promise for steady values, twice: the two starts may err in opposite directions.
// Where it says that its errors are larger, near resonance, these twice.
constexpr double curve_tolerance = 2e-9;
double allowed_at_point(const ComparedPoint& point) {
  return std::max(curve_tolerance, 2 * point.error);
}
constexpr const char* curve_reason = "each steady value is promised to 10⁻⁹, and both may be off";

// The speed ratio and the phase where stick begins, for `excess`.
struct Stick {
  double ratio, begin;
};

// Spring force over the friction bound while the elastic contact sticks, less its value at the
// start.
double excess(double tau, void* data) {
  const auto& [ratio, begin] = *static_cast<const Stick*>(data);
  return ratio * (tau - begin) - (std::cos(tau) - std::cos(begin));
}

// Stick of the elastic contact ends where the spring force reaches the friction bound. The excess
// falls from 0, has its only minimum where sin tau = -ratio again, and then rises to 2 pi ratio a
// period after the start: one root in between.
double end_of_stick(double begin, double ratio) {
  Stick stick{ratio, begin};
  gsl_function function{excess, &stick};
  const std::unique_ptr<gsl_root_fsolver, void (*)(gsl_root_fsolver*)> solver(
      gsl_root_fsolver_alloc(gsl_root_fsolver_brent), gsl_root_fsolver_free);
  gsl_root_fsolver_set(solver.get(), &function, 3 * pi - begin, begin + 2 * pi);
  int status = GSL_CONTINUE;
  for (int i = 0; i < 200 && status == GSL_CONTINUE; ++i) {
    gsl_root_fsolver_iterate(solver.get());
    status = gsl_root_test_interval(gsl_root_fsolver_x_lower(solver.get()),
                                    gsl_root_fsolver_x_upper(solver.get()), 0, 4 * GSL_DBL_EPSILON);
  }
  return gsl_root_fsolver_root(solver.get());
}

// As a share of what is allowed.
template <class Value>
const ComparedPoint* worst_point(const std::vector<ComparedPoint>& curve, Value difference) {
  const auto severity = [&](const ComparedPoint& point) {
    const double value = difference(point) / allowed_at_point(point);
    return std::isnan(value) ? infinity : value;
  };
  const auto worst = std::max_element(
      curve.begin(), curve.end(),
      [&](const ComparedPoint& a, const ComparedPoint& b) { return severity(a) < severity(b); });
  return worst == curve.end() ? nullptr : &*worst;
}

std::string at(const ComparedPoint& point) {
  return fmt::format("worst at {:.4g} of the sliding threshold", point.ratio);
}

Comparison curve_comparison(const char* key, const char* name, const char* reference) {
  Comparison comparison;
  comparison.key = key;
  comparison.name = name;
  comparison.reference = reference;
  comparison.measure = Comparison::Measure::absolute;
  comparison.tolerance = curve_tolerance;
  comparison.reason = curve_reason;
  return comparison;
}

void allow_at(Comparison& comparison, const ComparedPoint& worst) {
  comparison.detail = at(worst);
  comparison.tolerance = allowed_at_point(worst);
  if (comparison.tolerance > curve_tolerance)
    comparison.reason = "the simulator's own error there, and both may be off";
}

}  // namespace

std::vector<double> curve_ratios() {
  std::vector<double> ratios{0.01, 0.02, 0.03};
  for (int i = 2; i <= 36; ++i) ratios.push_back(i / 40.0);  // 0.05 to 0.9
  for (double ratio : {0.92, 0.94, 0.96, 0.97, 0.98, 0.985, 0.99, 0.995, 0.998, 0.999})
    ratios.push_back(ratio);
  for (double ratio : {1.001, 1.01, 1.05, 1.1, 1.2, 1.3, 1.4}) ratios.push_back(ratio);
  return ratios;
}

ComparedPoint friction_at(const simulation::System& system, double threshold, double ratio) {
  ComparedPoint point;
  point.ratio = ratio;
  point.velocity = ratio * threshold;
  const auto sliding = simulation::steady_state(system, point.velocity, Start::sliding);
  const auto rest = simulation::steady_state(system, point.velocity, Start::rest);
  point.from_sliding = sliding.friction_ratio;
  point.from_rest = rest.friction_ratio;
  point.error = std::max(sliding.friction_ratio_error, rest.friction_ratio_error);
  point.regime = to_text(sliding.regime);
  return point;
}

double elastic_friction(double amplitude_ratio, double ratio) {
  if (ratio >= 1) return 1;
  const double tau1 = pi + std::asin(ratio);
  const double tau2 = end_of_stick(tau1, ratio), stick = tau2 - tau1;
  const double taken =
      (std::sin(tau2) - std::sin(tau1) - stick * std::cos(tau1) - ratio * stick * stick / 2) /
      (2 * pi);
  return 1 - amplitude_ratio * taken;
}

Comparison compare_starts(const std::vector<ComparedPoint>& curve) {
  Comparison comparison =
      curve_comparison("starts", "friction curve, started from rest", "started from sliding");
  const auto apart = [](const ComparedPoint& p) { return std::abs(p.from_rest - p.from_sliding); };
  if (const ComparedPoint* worst = worst_point(curve, apart)) {
    comparison.expected = worst->from_sliding;
    comparison.found = worst->from_rest;
    allow_at(comparison, *worst);
  }
  return comparison;
}

Comparison compare_closed_form(const std::vector<ComparedPoint>& curve) {
  Comparison comparison = curve_comparison("closed_form", "friction curve by simulation",
                                           "closed form, elastic contact");
  const auto apart = [](const ComparedPoint& p) {
    return std::abs(p.from_sliding - *p.closed_form);
  };
  if (const ComparedPoint* worst = worst_point(curve, apart)) {
    comparison.expected = *worst->closed_form;
    comparison.found = worst->from_sliding;
    allow_at(comparison, *worst);
  }
  return comparison;
}

}  // namespace vcrit::validation
