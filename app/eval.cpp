// vcrit eval: v* of a scene, correctly rounded, and whether Eq. 24 applies.
#include <fmt/core.h>
#include <unistd.h>
#include <CLI/App.hpp>

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "answers/critical_onset.hpp"
#include "answers/effect_words.hpp"
#include "answers/under_load.hpp"
#include "base/constants.hpp"
#include "base/joined.hpp"
#include "base/rounded.hpp"
#include "commands.hpp"
#include "critical/admissibility.hpp"
#include "facts/facts.hpp"
#include "options.hpp"
#include "record/fields.hpp"
#include "rules/kinds.hpp"
#include "streams.hpp"

namespace vcrit::app {

namespace {

struct Evaluation {
  CriticalOnset critical;
  std::vector<std::string> reasons;  // why not admissible
  std::optional<bool> opens;         // told where the scene has separation = true
  std::vector<std::string> facts;    // what the formula says
  std::vector<std::string> warnings;
  Effect effect;
  std::optional<UnderLoad> load = {};
  std::optional<BelowMount> mount = {};
  bool simulated() const { return critical.by != CriticalOnset::By::formula; }
  bool by_phase() const { return critical.by == CriticalOnset::By::maximum_over_the_phase; }

  friend void fields(record::Fields& f, const Evaluation& it) {
    const CriticalOnset& onset = it.critical;
    const auto known = [](double value) {
      return std::isnan(value) ? std::nullopt : std::optional(value);
    };
    std::vector<std::string> all_reasons = it.reasons;
    if (!onset.reason.empty()) all_reasons.push_back(onset.reason);
    f("critical_velocity", onset.contact_velocity);
    f("relative_error_bound", known(onset.relative_error_bound));
    f("admissible", it.reasons.empty())("reasons", all_reasons);
    f("drive_velocity", onset.drive_velocity);
    if (const std::vector<int>& free = onset.free_harmonics; !free.empty()) {
      f("sliding_from", known(onset.sliding_from))("free_harmonic", free.front());
      f.when(free.size() > 1, "free_harmonics", free);
    }
    f.some("opens", it.opens);
    if (it.opens || it.by_phase()) {
      f("critical_velocity_by", to_text(onset.by));
      f.when(it.simulated(), "relative_error_estimate", onset.relative_error);
    }
    if (it.load) fields(f, *it.load);
    if (it.mount) fields(f, *it.mount);
    f("facts", it.facts).some("warnings", it.warnings);
    f("sentence", sentence(it.effect))("effect", it.effect);
  }
};

Evaluation evaluated(const Problem& problem) {
  const CriticalOnset critical = critical_onset(problem);
  Evaluation result{critical,
                    inadmissible_reasons(problem),
                    {},
                    symbolic::facts_in_text(problem),
                    problem->source->warnings,
                    effect_of(problem, critical),
                    under_load(problem),
                    below_mount(problem)};
  const rules::Facts facts(problem);
  if (facts.is(rules::SceneKind::separating)) result.opens = facts.opens();
  return result;
}

// Among numbers there is no room for a formula of several steps.
std::string brief(const std::string& fact) {
  constexpr std::size_t room = 78;  // beside the headings, on a wide terminal
  return fact.size() <= room ? fact : fact.substr(0, fact.find(": ")) + " (vcrit derive shows it)";
}

// Where the formula does not describe the motion, the line says so.
std::string velocity_words(const Evaluation& result, int digits) {
  const double critical = result.critical.contact_velocity;
  if (!result.reasons.empty())
    return fmt::format("v* = {} by the formula, which does not describe this motion",
                       rounded(critical, "m/s", digits));
  const char* what = result.by_phase()        ? " (maximum over the phase)"
                     : result.simulated()     ? " (simulated)"
                     : result.effect.creeps() ? " of the contact point"
                                              : "";
  return fmt::format("v* = {}{}", critical_velocity_in_words(result.effect, digits), what);
}

std::string full_friction_words(const CriticalOnset& critical, int digits) {
  if (critical.free_harmonics.empty()) return {};
  std::vector<std::string> harmonics;
  for (const int n : critical.free_harmonics) harmonics.push_back(std::to_string(n));
  return fmt::format("{}: the undamped body swings freely at {} {}",
                     std::isnan(critical.sliding_from)
                         ? "from a speed below v* on that is not known"
                         : fmt::format("from {} on", rounded(critical.sliding_from, "m/s", digits)),
                     harmonics.size() > 1 ? "harmonics" : "harmonic", joined(harmonics, ", "));
}

std::string error_words(const Effect& effect, int digits) {
  const std::string error = rounding_error(effect);
  if (error.empty() || digits == all_digits) return error;
  return fmt::format("{:<20}all digits: --digits {}", error, all_digits);
}

void print_eval_text(const Problem& problem, const Evaluation& result, int digits) {
  const Effect& effect = result.effect;
  if (!problem->source->title.empty()) fmt::print("{}\n", problem->source->title);
  const std::string told = sentence(effect, digits);
  const bool outside = effect.kind == Effect::Kind::outside;
  fmt::print("{}\n\n{}\n", conditions(effect, digits),
             outside ? alarming(told, STDOUT_FILENO) : told);
  print_row("critical velocity", velocity_words(result, digits));
  print_row("lowest friction", lowest_friction(effect, digits));
  if (result.mount)
    print_row("contact's amplitude",
              fmt::format("{}, {}° from the vibrator's phase",
                          rounded(result.mount->amplitude, "m", digits),
                          rounded(result.mount->mount_phase * 180 / pi, "", digits)));
  print_row("full friction", full_friction_words(result.critical, digits));
  print_row("contact closed", closed_range(effect, digits));
  print_row("rounding error", error_words(effect, digits));
  const char* heading = "outside the model";
  for (const std::string& reason : result.reasons) print_row(std::exchange(heading, ""), reason);
  heading = "the formula says";
  for (const std::string& fact : result.facts) print_row(std::exchange(heading, ""), brief(fact));
}

}  // namespace

void add_eval(CLI::App& program) {
  struct Options {
    SceneOptions scene;
    int digits = few_digits;
    bool json = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("eval", "Critical velocity of a scene as a number");
  options->scene.add_to(*command);
  add_digits(*command, options->digits);
  command->add_flag("--json", options->json, "print one JSON object");
  command->callback([options] {
    const Problem problem = options->scene.read();
    const Evaluation result = evaluated(problem);
    if (options->json)
      print(record::json_of(result));
    else
      print_eval_text(problem, result, options->digits);
  });
}

}  // namespace vcrit::app
