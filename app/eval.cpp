// vcrit eval: v* of a scene, correctly rounded, and whether Eq. 24 applies.
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "answers/critical_onset.hpp"
#include "commands.hpp"
#include "critical/admissibility.hpp"
#include "options.hpp"
#include "rules/kinds.hpp"

namespace vcrit::app {

namespace {

struct Result {
  CriticalOnset critical;
  std::vector<std::string> reasons;  // why not admissible
  bool simulated() const { return critical.by == CriticalOnset::By::simulation; }
};

// All digits, of a simulated v* those that its error leaves.
std::string true_digits(const CriticalOnset& critical) {
  const double error = critical.relative_error, value = critical.contact_velocity;
  if (!(error > 0.5e-15)) return fmt::format("{}", value);
  const int digits = static_cast<int>(-std::log10(2 * error));
  return fmt::format("{:.{}g}", value, std::max(digits, 1));
}

const char* surface_words(const Problem& problem) {
  const rules::Facts facts(problem);
  if (facts.is(rules::Kind::never_meeting)) return "never meet";
  return facts.opens() ? "part for a while in each period" : "always touch";
}

std::string border_words(double sliding_from) {
  if (std::isnan(sliding_from)) return "from a speed below v* on that is not known";
  return fmt::format("from {} m/s on", sliding_from);
}

// What the surfaces do is told where the scene lets them part.
void print_eval_json(const Problem& problem, const Result& result) {
  std::vector<std::string> reasons = result.reasons;
  if (!result.critical.reason.empty()) reasons.push_back(result.critical.reason);
  nlohmann::ordered_json object{
      {"critical_velocity", json_number(result.critical.contact_velocity)},
      {"relative_error_bound",
       result.simulated() ? nullptr : json_number(result.critical.relative_error_bound)},
      {"admissible", result.reasons.empty()},
      {"reasons", reasons},
      {"drive_velocity", json_number(result.critical.drive_velocity)}};
  const std::vector<int>& free = result.critical.free_harmonics;
  if (!free.empty()) {
    object["sliding_from"] = json_number(result.critical.sliding_from);
    object["free_harmonic"] = free.front();
    if (free.size() > 1) object["free_harmonics"] = free;
  }
  if (problem->separation) {
    object["opens"] = opens(problem);
    object["critical_velocity_by"] = result.simulated() ? "simulation" : "formula";
    if (result.simulated())
      object["relative_error_estimate"] = json_number(result.critical.relative_error);
  }
  print(with_warnings(object, problem->source->warnings));
}

void print_eval_text(const Problem& problem, const Result& result) {
  if (!problem->source->title.empty()) fmt::print("{}\n", problem->source->title);
  const double critical = result.critical.contact_velocity;
  fmt::print("critical velocity v*  {} m/s{}\n", true_digits(result.critical),
             result.simulated() ? " (simulated)" : "");
  if (!result.critical.reason.empty())
    fmt::print("                      {}\n", result.critical.reason);
  if (!result.simulated())
    fmt::print("rounding error        at most {:.2g}\n", result.critical.relative_error_bound);
  else if (std::isfinite(critical))
    fmt::print("rounding error        about {:.2g}\n", result.critical.relative_error);
  if (result.critical.drive_velocity != critical)
    fmt::print("drive velocity        {} m/s (the path creeps)\n", result.critical.drive_velocity);
  if (const std::vector<int>& free = result.critical.free_harmonics; !free.empty())
    fmt::print("steady sliding        {}: the undamped body swings freely at {} {}\n",
               border_words(result.critical.sliding_from),
               free.size() > 1 ? "harmonics" : "harmonic", fmt::join(free, ", "));
  if (problem->separation) fmt::print("surfaces              {}\n", surface_words(problem));
  fmt::print("admissible            {}\n", result.reasons.empty() ? "yes" : "no");
  for (const std::string& reason : result.reasons) fmt::print("                      {}\n", reason);
}

}  // namespace

void add_eval(CLI::App& program) {
  struct Options {
    SceneOptions scene;
    bool json = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("eval", "Critical velocity of a scene as a number");
  options->scene.add_to(*command);
  command->add_flag("--json", options->json, "print one JSON object");
  command->callback([options] {
    const Problem problem = options->scene.read();
    const Result result{critical_onset(problem), inadmissible_reasons(problem)};
    if (options->json)
      print_eval_json(problem, result);
    else
      print_eval_text(problem, result);
  });
}

}  // namespace vcrit::app
