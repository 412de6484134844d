// Time and error of all ways to evaluate v*, in one run on one core.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "harness/commands.hpp"
#include "speed/tables.hpp"

namespace vcrit::bench {

namespace {

using namespace speed;

struct EvaluatorOptions {
  std::string compiler = "g++", only, json;
  bool markdown = false;
  Plan plan;
};

std::vector<Subject> chosen_subjects(const EvaluatorOptions& options) {
  std::vector<Subject> chosen;
  std::string known;
  for (Subject& subject : all_subjects()) {
    known += (known.empty() ? "" : ", ") + subject.name;
    if (options.only.empty() || subject.name == options.only) chosen.push_back(std::move(subject));
  }
  if (chosen.empty()) throw InputError({"--only"}, "\"" + options.only + "\"", "one of " + known);
  return chosen;
}

void run_evaluators(const EvaluatorOptions& options) {
  const std::vector<Subject> subjects = chosen_subjects(options);
  const std::filesystem::path compiler = compiler_named(options.compiler);
  const validation::PrivateFolder folder;
  SpeedComparison all;
  all.compiler = validation::describe_compiler(compiler, folder.path());
  all.plan = options.plan;
  for (const Subject& subject : subjects) {
    fmt::print(stderr, "{}\n", subject.name);
    all.subjects.push_back(subject.name);
    const std::vector<TimedMethod> methods = evaluators(subject, compiler, all.missing);
    for (const CallMode mode : both_modes)
      for (Result& each : measure(subject, mode, methods, options.plan))
        all.results.push_back(std::move(each));
  }
  fmt::print("{}", heading(all));
  for (const CallMode mode : both_modes)
    fmt::print("{}", table(all, mode, options.markdown ? TableStyle::markdown : TableStyle::text));
  fmt::print("{}", notes(all));
  if (!options.json.empty()) write_file(options.json, as_json(all) + "\n");
}

}  // namespace

void add_evaluators(CLI::App& program, int&) {
  const auto options = std::make_shared<EvaluatorOptions>();
  CLI::App& command = *program.add_subcommand(
      "evaluators", "Time and error of all ways to evaluate the critical velocity.");
  command.add_option("--compiler", options->compiler, "g++ or clang++")->capture_default_str();
  command.add_option("--only", options->only, "only this problem");
  command.add_option("--values", options->plan.values, "length of the arrays")
      ->check(CLI::Range(8, 1 << 20))
      ->capture_default_str();
  command.add_option("--seconds", options->plan.seconds, "for a problem in one mode")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command.add_flag("--markdown", options->markdown, "tables for docs/benchmarks.md");
  command.add_option("--json", options->json, "also write all figures to this file");
  command.callback([options] { run_evaluators(*options); });
}

}  // namespace vcrit::bench
