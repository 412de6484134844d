// vcrit solve: what amplitude, frequency, load or speed reaches a wanted friction ratio.
#include "design/solve.hpp"

#include <fmt/core.h>
#include <CLI/App.hpp>

#include <memory>
#include <optional>

#include "answers/realised_friction.hpp"
#include "base/constants.hpp"
#include "base/rounded.hpp"
#include "base/units.hpp"
#include "commands.hpp"
#include "critical/admissibility.hpp"
#include "design/opening.hpp"
#include "options.hpp"
#include "problem/variants.hpp"
#include "record/fields.hpp"
#include "rules/kinds.hpp"
#include "streams.hpp"

namespace vcrit::app {

namespace {

using design::DesignAnswer;
using design::DesignQuestion;
using design::Sought;

struct SolveOptions {
  SceneOptions scene;
  std::string sought, friction_ratio, velocity, from, to;
  std::optional<int> samples;
  int digits = few_digits;
  bool json = false;
};

std::vector<std::string> names_of_sought() {
  std::vector<std::string> names;
  for (const Sought sought : design::all_sought) names.emplace_back(to_text(sought));
  return names;
}

Sought sought_by(const std::string& name) {
  for (const Sought sought : design::all_sought)
    if (name == to_text(sought)) return sought;
  throw Bug("a name that is not offered");
}

bool is_sought(const Symbol& symbol, Sought sought, const Problem& problem) {
  if (sought == Sought::amplitude) return symbol == problem->amplitude.symbol;
  if (sought == Sought::force) return problem->load && symbol == problem->load->symbol;
  return sought == Sought::frequency &&
         (symbol == problem->angular_frequency.symbol || symbol == frequency_symbol);
}

void refuse_setting_of_sought(const SolveOptions& options, const DesignQuestion& question) {
  for (const auto& [name, value] : question.problem->source->settings)
    if (is_sought(question.problem->source->named.at(name), question.sought, question.problem))
      throw InputError({"--set"}, fmt::format("{} with --for {}", name, options.sought),
                       "no value for what is sought");
}

std::optional<double> end_of_range(const std::string& text, Sought sought, const char* option) {
  if (text.empty()) return std::nullopt;
  return parse_quantity(text, dimension_of(sought), {option});
}

DesignQuestion question_of(const SolveOptions& options) {
  const Sought sought = sought_by(options.sought);
  const bool speed = sought == Sought::velocity;
  if (options.velocity.empty() != speed)
    throw InputError({"--velocity"}, speed ? "a velocity with --for velocity" : "none",
                     speed ? "none: it is what is sought" : "the velocity of the drive");
  const double velocity =
      speed ? 0 : parse_quantity(options.velocity, Dimension::velocity, {"--velocity"});
  const auto from = end_of_range(options.from, sought, "--from");
  const auto to = end_of_range(options.to, sought, "--to");
  const DesignQuestion question{
      options.scene.read(sought == Sought::frequency ? SceneOptions::Frequency::varied
                                                     : SceneOptions::Frequency::of_the_scene),
      sought,
      ratio_of(options.friction_ratio, "--friction-ratio", "a ratio below 1: 0.8 or 80%"),
      velocity,
      from,
      to,
      options.samples};
  refuse_setting_of_sought(options, question);
  return question;
}

struct Solution {
  const DesignQuestion& question;
  const DesignAnswer& answer;

  friend void fields(record::Fields& f, const Solution& it) {
    const auto& [asked, found] = it;
    f("for", asked.sought)("value", found.value)("unit", unit_of(asked.sought));
    f("value_error", found.value_error)("at_start", found.at_start);
    f("wanted_friction_ratio", asked.friction_ratio);
    f("friction_ratio", found.state.friction_ratio);
    f("friction_ratio_error", found.state.friction_ratio_error)("regime", found.state.regime);
    f("velocity", found.velocity)("critical_velocity", found.critical_velocity);
    f.group("limits", [&](record::Fields& limits) {
      limits("amplitude", it.answer.largest_amplitude)("frequency", it.answer.largest_frequency);
    });
    f.group("searched", [&](record::Fields& searched) {
      searched("from", it.answer.from)("to", it.answer.to)("samples", it.answer.samples);
      searched("evaluations", it.answer.evaluations)("unanswered", it.answer.unanswered);
    });
    f.some("warnings", asked.problem->source->warnings);
  }
};

std::string solved_words(const DesignQuestion& question, const DesignAnswer& answer, int digits) {
  const std::string value = rounded(answer.value, unit_of(question.sought), digits);
  const std::string speed = rounded(answer.velocity, "m/s", digits);
  const std::string ratio = rounded(question.friction_ratio, "", digits);
  switch (question.sought) {
    case Sought::amplitude:
      return fmt::format("From an amplitude of {}, the friction ratio at {} is {} or less.", value,
                         speed, ratio);
    case Sought::frequency:
      return fmt::format("From a frequency of {}, the friction ratio at {} is {} or less.", value,
                         speed, ratio);
    case Sought::force: {
      // On a path that creeps smaller loads may have more friction.
      const bool creeps = creep_velocity(design::with_load(question.problem, answer.value)) > 0;
      return fmt::format("{} a load of {}, the friction ratio at {} is {} or less.",
                         creeps ? "At" : "Up to", value, speed, ratio);
    }
    case Sought::velocity:
      return fmt::format("Up to {} the friction ratio is {} or less.", value, ratio);
  }
  throw Bug("something sought without a sentence");
}

std::string closed_words(const DesignAnswer& answer, bool below_indenter, int digits) {
  if (!(answer.largest_amplitude > 0)) return "at no amplitude";
  std::string text =
      fmt::format("{}below an amplitude of {}", below_indenter ? "at its centre " : "",
                  rounded(answer.largest_amplitude, "m", digits));
  if (answer.largest_frequency)
    text += fmt::format(", or a frequency of {}", rounded(*answer.largest_frequency, "Hz", digits));
  return text;
}

void print_solve_text(const DesignQuestion& question, const DesignAnswer& answer, int digits) {
  const auto in_unit = [&](double value, int shown) {
    return rounded(value, unit_of(question.sought), shown);
  };
  fmt::print("{}\n", solved_words(question, answer, digits));
  print_row(to_text(question.sought),
            fmt::format("{}, the {} (error about {})", in_unit(answer.value, digits),
                        is_largest(question.sought) ? "largest" : "smallest",
                        in_unit(answer.value_error, 1)));
  if (answer.at_start) print_row("", "the range begins with it: what lies before was not searched");
  print_row(
      "friction ratio",
      fmt::format("{} (wanted: {}), {}", rounded(answer.state.friction_ratio, "", digits),
                  rounded(question.friction_ratio, "", digits), to_text(answer.state.regime)));
  print_row("sliding speed",
            fmt::format("{}, {} times v*", rounded(answer.velocity, "m/s", digits),
                        rounded(answer.velocity / answer.critical_velocity, "", digits)));
  print_row("contact closed", closed_words(answer, rules::cells_move(question.problem), digits));
  const std::string from = in_unit(answer.from, digits), to = in_unit(answer.to, digits);
  if (answer.monotonic)
    print_row("searched", fmt::format("{} to {}; below an indenter friction never falls with the "
                                      "speed",
                                      from, to));
  else
    print_row("searched", fmt::format("{} to {} in {} samples; a dip narrower than one sample can "
                                      "be missed (use --samples)",
                                      from, to, answer.samples));
}

void warn_of_answer(DesignQuestion& question, const std::string& warning) {
  warn(warning);
  std::vector<std::string> warnings = question.problem->source->warnings;
  warnings.push_back(warning);
  question.problem = warning_of(question.problem, std::move(warnings));
}

void run_solve(const SolveOptions& options) {
  DesignQuestion question = question_of(options);
  const DesignAnswer answer = design::solve(question);
  for (const std::string& warning : unstated_error(question.problem))
    warn_of_answer(question, warning);
  // The smallest frequency rests on all frequencies below it, which were searched, too.
  if (question.sought == Sought::frequency)
    if (const auto beyond =
            beyond_fitted_range(question.problem, two_pi * answer.from, two_pi * answer.value))
      warn_of_answer(question, *beyond);
  if (options.json)
    print(record::json_of(Solution{question, answer}));
  else
    print_solve_text(question, answer, options.digits);
}

}  // namespace

void add_solve(CLI::App& program) {
  const auto options = std::make_shared<SolveOptions>();
  CLI::App* command = program.add_subcommand(
      "solve",
      "Smallest amplitude or frequency, or largest load or velocity, for a friction ratio");
  options->scene.add_to(*command);
  command->add_option("--for", options->sought, "what is sought")
      ->required()
      ->check(CLI::IsMember(names_of_sought()));
  command
      ->add_option("--friction-ratio", options->friction_ratio,
                   "friction to reach, over that without vibration: 0.8 or 80%")
      ->type_name("RATIO")
      ->required();
  command->add_option("--velocity", options->velocity,
                      "mean velocity of the drive: 0.02 or \"20 mm/s\"; not with --for velocity");
  command->add_option("--from", options->from, "lower end of the search range");
  command->add_option("--to", options->to, "upper end of the search range");
  command->add_option("--samples", options->samples,
                      fmt::format("how many values of the range are tried ({}, or {} below an "
                                  "indenter)",
                                  design::usual_samples, design::usual_samples_below_indenter));
  add_digits(*command, options->digits);
  command->add_flag("--json", options->json, "print one JSON object");
  command->callback([options] { run_solve(*options); });
}

}  // namespace vcrit::app
