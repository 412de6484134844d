// vcrit eval: v* of a scene, correctly rounded, and whether Eq. 24 applies.
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "answers/critical_onset.hpp"
#include "commands.hpp"
#include "critical/admissibility.hpp"
#include "facts/facts.hpp"
#include "options.hpp"
#include "record/fields.hpp"
#include "rules/kinds.hpp"

namespace vcrit::app {

namespace {

struct Evaluation {
  CriticalOnset critical;
  std::vector<std::string> reasons;  // why not admissible
  std::optional<bool> opens;         // told where the scene has separation = true
  std::vector<std::string> facts;    // what the formula says
  std::vector<std::string> warnings;
  bool simulated() const { return critical.by == CriticalOnset::By::simulation; }

  friend void fields(record::Fields& f, const Evaluation& it) {
    const CriticalOnset& critical = it.critical;
    const auto known = [](double value) {
      return std::isnan(value) ? std::nullopt : std::optional(value);
    };
    std::vector<std::string> reasons = it.reasons;
    if (!critical.reason.empty()) reasons.push_back(critical.reason);
    f("critical_velocity", critical.contact_velocity);
    f("relative_error_bound", known(critical.relative_error_bound));
    f("admissible", it.reasons.empty())("reasons", reasons);
    f("drive_velocity", critical.drive_velocity);
    if (const std::vector<int>& free = critical.free_harmonics; !free.empty()) {
      f("sliding_from", known(critical.sliding_from))("free_harmonic", free.front());
      f.when(free.size() > 1, "free_harmonics", free);
    }
    if (it.opens) {
      f("opens", *it.opens)("critical_velocity_by", it.simulated() ? "simulation" : "formula");
      f.when(it.simulated(), "relative_error_estimate", critical.relative_error);
    }
    f("facts", it.facts).some("warnings", it.warnings);
  }
};

// All digits, of a simulated v* those that its error leaves.
std::string true_digits(const CriticalOnset& critical) {
  const double error = critical.relative_error, value = critical.contact_velocity;
  if (!(error > 0.5e-15)) return fmt::format("{}", value);
  const int digits = static_cast<int>(-std::log10(2 * error));
  return fmt::format("{:.{}g}", value, std::max(digits, 1));
}

const char* contact_words(const Problem& problem) {
  const rules::Facts facts(problem);
  if (facts.is(rules::SceneKind::never_closing)) return "never closes";
  if (facts.opens()) return "opens in each period";
  return problem->indenter ? "stays closed at the centre" : "stays closed";
}

std::string border_words(double sliding_from) {
  if (std::isnan(sliding_from)) return "from a speed below v* on that is not known";
  return fmt::format("from {} m/s on", sliding_from);
}

Evaluation evaluated(const Problem& problem) {
  Evaluation result{critical_onset(problem),
                    inadmissible_reasons(problem),
                    {},
                    symbolic::facts_in_text(problem),
                    problem->source->warnings};
  if (problem->separation) result.opens = opens(problem);
  return result;
}

// A formula of several steps has no place among numbers.
std::string brief(const std::string& fact) {
  constexpr std::size_t room = 78;  // beside the headings, on a wide terminal
  return fact.size() <= room ? fact : fact.substr(0, fact.find(": ")) + " (vcrit derive shows it)";
}

void print_eval_text(const Problem& problem, const Evaluation& result) {
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
  if (result.opens) fmt::print("contact               {}\n", contact_words(problem));
  fmt::print("admissible            {}\n", result.reasons.empty() ? "yes" : "no");
  for (const std::string& reason : result.reasons) fmt::print("                      {}\n", reason);
  const char* heading = "the formula says";
  for (const std::string& fact : result.facts) {
    fmt::print("{:<22}{}\n", heading, brief(fact));
    heading = "";
  }
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
    const Evaluation result = evaluated(problem);
    if (options->json)
      print(record::json_of(result));
    else
      print_eval_text(problem, result);
  });
}

}  // namespace vcrit::app
