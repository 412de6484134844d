#include "report/verdict.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "answers/effect_words.hpp"
#include "report/units.hpp"

namespace vcrit::validation::report {

std::string title_of(const SceneReport& report) {
  return report.problem->source->title.empty() ? report.problem->source->file
                                               : report.problem->source->title;
}

const char* state_class(const SceneReport& report) {
  if (!passed(report)) return "failed";
  if (!report.reasons.empty()) return "outside";
  return count(report, Comparison::Outcome::not_run) > 0 ? "not-run" : "passed";
}

std::string state_words(const SceneReport& report) {
  const std::string words = count_words(report.comparisons);
  if (report.reasons.empty()) return words;
  return "Outside the model: no v*, not simulated" +
         (passed(report) ? std::string() : "; " + words);
}

std::string sentence_of(const SceneReport& report) {
  if (report.effect) return sentence(*report.effect);
  if (!report.failure.empty()) return "No answer: the comparisons came to no end.";
  return "No answer: " + (report.reasons.empty() ? "v* is not known" : report.reasons.front()) +
         ".";
}

std::string warning_of_failed(const SceneReport& report) {
  return failed_checks(count(report, Comparison::Outcome::failed),
                       report.comparisons.size() - count(report, Comparison::Outcome::not_run));
}

namespace {

std::string closest_words(double share) {
  constexpr double least = 1e-4;  // of less the digits say nothing
  if (share == 0) return ", without any difference";
  if (share < least) return ": the closest used less than 0.01 % of its tolerance";
  return fmt::format(": the closest used {:.2g} % of its tolerance", 100 * share);
}

}  // namespace

std::string checks_words(const SceneReport& report) {
  const auto failed = count(report, Comparison::Outcome::failed),
             not_run = count(report, Comparison::Outcome::not_run),
             made = report.comparisons.size() - not_run;
  std::string words = failed > 0 ? fmt::format("{} of {} checks failed", failed, made)
                                 : fmt::format("{} check{} passed", made, made == 1 ? "" : "s");
  const Comparison* closest = tightest(report);
  if (failed == 0 && closest != nullptr && closest->tolerance > 0)
    words += closest_words(difference(*closest) / closest->tolerance);
  if (not_run > 0) words += fmt::format("; {} could not be run", not_run);
  return words + ".";
}

std::string velocity_words(const SceneReport& report) {
  if (!report.reasons.empty()) return {};
  if (report.effect && report.effect->by_phase && std::isfinite(report.effect->critical_velocity))
    return "v* = " + quantity(report.effect->critical_velocity, "m/s", 5);
  if (!report.failure.empty()) return "no v*";
  if (report.indented && !report.indented->closed_form)
    return "v* = " + quantity(report.indented->critical_velocity, "m/s", 5) + ", simulated";
  if (report.separation && !report.separation->closed_form)
    return std::isinf(report.separation->critical_velocity)
               ? "no v*"
               : "v* = " + quantity(report.separation->critical_velocity, "m/s", 5) + ", simulated";
  return "v* = " + quantity(report.critical_velocity, "m/s", 5);
}

std::string count_words(std::size_t made, std::size_t failed, std::size_t not_run) {
  std::string words = failed > 0
                          ? fmt::format("{} of {} comparisons failed", failed, made)
                          : fmt::format("{} comparison{} passed", made, made == 1 ? "" : "s");
  if (not_run > 0) words += fmt::format(", {} not run", not_run);
  return words;
}

std::string count_words(const std::vector<Comparison>& comparisons) {
  const auto not_run = count(comparisons, Comparison::Outcome::not_run);
  return count_words(comparisons.size() - not_run, count(comparisons, Comparison::Outcome::failed),
                     not_run);
}

std::string tightest_words(const std::vector<Comparison>& comparisons) {
  const Comparison* worst = tightest(comparisons);
  if (worst == nullptr) return {};
  if (worst->broken) return fmt::format("{}: {}", worst->name, worst->detail);
  return fmt::format("Largest difference relative to its tolerance: {}, {} of {} allowed.",
                     worst->name, magnitude(difference(*worst)), magnitude(worst->tolerance));
}

}  // namespace vcrit::validation::report
