#include "compare/velocity_comparisons.hpp"

#include <fmt/core.h>

#include <cmath>
#include <memory>
#include <utility>

#include "base/rounded.hpp"
#include "compare/evaluators.hpp"
#include "critical/conditioning.hpp"
#include "derivation/derivation.hpp"
#include "problem/variants.hpp"
#include "run/compiler.hpp"

namespace vcrit::validation {

Comparison velocity_comparison(const SceneReport& report, const char* key, const char* name) {
  Comparison comparison;
  comparison.key = key;
  comparison.name = name;
  comparison.reference = formula_reference;
  comparison.unit = "m/s";
  comparison.expected = report.velocity_of_doubles;
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

Comparison in_doubles(const SceneReport& report, const char* key, const char* name, double found) {
  Comparison comparison = velocity_comparison(report, key, name);
  comparison.found = found;
  comparison.tolerance = formula_tolerance(report.condition);
  comparison.reason =
      fmt::format("doubles: 32 roundings of 2⁻⁵³, times the condition number {:.3g} of Eq. 24 here",
                  report.condition);
  if (leaves_digits(comparison.tolerance)) return comparison;
  return not_run(comparison, lost_digits);
}

bool is_speed(double velocity) { return std::isfinite(velocity) && velocity > 0; }

Comparison derived_comparison(const SceneReport& report, const symbolic::Derivation& derivation,
                              const Values& values) {
  Comparison comparison = velocity_comparison(report, "derived", "derived formula, 50 digits");
  comparison.tolerance = unit_roundoff * (2 + report.condition);
  comparison.reason = fmt::format(
      "each is rounded once; a decimal ratio is exact in one and a double in the other: one more, "
      "times the condition number {:.3g}",
      report.condition);
  if (!is_speed(report.critical_velocity))
    return not_run(comparison, "v* is infinite or 0: no relative error");
  if (!leaves_digits(comparison.tolerance)) return not_run(comparison, lost_digits);
  try {
    comparison.found = derived_velocity(derivation, values);
    return comparison;
  } catch (const std::exception& error) {
    return broken(comparison, error.what());
  }
}

namespace {

Comparison certified_by_generated(const SceneReport& report, const GeneratedVelocities& generated) {
  Comparison comparison =
      velocity_comparison(report, "generated_certified", "generated evaluator, certified");
  comparison.found = generated.certified;
  comparison.tolerance = generated.certified_bound + unit_roundoff;
  comparison.reason = fmt::format("its own bound, {}, and one rounding of the reference",
                                  rounded(generated.certified_bound, "", 2));
  if (std::isfinite(generated.certified_bound)) return comparison;
  return not_run(comparison, "it gives no bound here");
}

/// detail: whose evaluator it is.
void add_generated(SceneReport& report, const GeneratedVelocities& generated,
                   const std::string& detail) {
  const auto add = [&](const char* key, const char* name, double found) {
    report.comparisons.push_back(in_doubles(report, key, name, found));
  };
  const std::size_t first = report.comparisons.size();
  add("generated", "generated evaluator", generated.accurate);
  add("generated_batch", "generated evaluator, batch call", generated.batch);
  add("generated_fast", "generated evaluator, fast grade", generated.fast);
  report.comparisons.push_back(certified_by_generated(report, generated));
  for (std::size_t i = first; i < report.comparisons.size(); ++i)
    if (std::string& said = report.comparisons[i].detail; said.empty()) said = detail;
}

/// Of the same contact where it stays closed, for which the same Eq. (24) is derived.
std::unique_ptr<Driver> closed_driver(const Driver& driver) {
  symbolic::Derivation derivation = driver.derivation();
  if (!derivation.problem->separation) return nullptr;
  derivation.problem = staying_closed(derivation.problem);
  auto closed = std::make_unique<Driver>(std::move(derivation));
  closed->generate();
  return closed->has("accurate") ? std::move(closed) : nullptr;
}

}  // namespace

void compare_generated(SceneReport& report, Driver& driver, const Values& values) {
  const Comparison plain = in_doubles(report, "generated", "generated evaluator", 0);
  const auto compiler = find_compiler();
  if (!compiler) {
    report.comparisons.push_back(not_run(plain, "no C++ compiler found"));
    return;
  }
  try {
    report.compiler = describe_compiler(*compiler, PrivateFolder().path());
    driver.generate();
    if (driver.has("accurate")) {
      driver.compile(*compiler);
      add_generated(report, generated_velocities(driver, values), {});
    } else if (const auto closed = closed_driver(driver)) {
      closed->compile(*compiler);
      add_generated(report, generated_velocities(*closed, values),
                    "the evaluator of the contact that stays closed");
    } else {
      report.comparisons.push_back(not_run(plain, driver.missing().front().reason));
    }
  } catch (const std::runtime_error& error) {
    report.comparisons.push_back(broken(plain, error.what()));
  }
}

}  // namespace vcrit::validation
