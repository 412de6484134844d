#include "compare/scene_report.hpp"

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"

namespace vcrit::validation {

double difference(const Comparison& comparison) {
  if (comparison.found == comparison.expected) return 0;
  double apart = std::abs(comparison.found - comparison.expected);
  if (comparison.measure == Comparison::Measure::relative) apart /= std::abs(comparison.expected);
  return std::isnan(apart) ? infinity : apart;
}

Comparison::Outcome outcome(const Comparison& comparison) {
  if (comparison.not_run) return Comparison::Outcome::not_run;
  const double apart = difference(comparison);
  const bool holds = !comparison.broken && std::isfinite(apart) && apart <= comparison.tolerance;
  return holds ? Comparison::Outcome::passed : Comparison::Outcome::failed;
}

const char* to_text(Comparison::Outcome outcome) {
  switch (outcome) {
    case Comparison::Outcome::passed:
      return "passed";
    case Comparison::Outcome::failed:
      return "failed";
    case Comparison::Outcome::not_run:
      return "not run";
  }
  throw Bug("an outcome without a name");
}

std::size_t count(const std::vector<Comparison>& comparisons, Comparison::Outcome what) {
  return static_cast<std::size_t>(
      std::count_if(comparisons.begin(), comparisons.end(),
                    [&](const Comparison& comparison) { return outcome(comparison) == what; }));
}

const Comparison* tightest(const std::vector<Comparison>& comparisons) {
  const auto severity = [](const Comparison& comparison) {
    if (comparison.not_run) return -1.0;
    if (comparison.broken) return infinity;
    const double apart = difference(comparison);
    return apart == 0 ? 0 : apart / comparison.tolerance;
  };
  const auto worst = std::max_element(
      comparisons.begin(), comparisons.end(),
      [&](const Comparison& a, const Comparison& b) { return severity(a) < severity(b); });
  return worst == comparisons.end() || worst->not_run ? nullptr : &*worst;
}

std::size_t count(const SceneReport& report, Comparison::Outcome what) {
  return count(report.comparisons, what);
}

bool passed(const SceneReport& report) { return count(report, Comparison::Outcome::failed) == 0; }

const Comparison* tightest(const SceneReport& report) { return tightest(report.comparisons); }

}  // namespace vcrit::validation
