// vcrit_speed: time and error of all ways to evaluate v*, in one run on one core. Tables on stdout,
// progress on stderr.
#include <fmt/core.h>

#include <CLI/CLI.hpp>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "speed/tables.hpp"

namespace {

using namespace vcrit::speed;

struct Options {
  std::string compiler = "g++", only, json;
  bool markdown = false;
  Plan plan;
};

Options parsed(int count, char** words) {
  CLI::App program("Time and error of all ways to evaluate the critical velocity.");
  Options options;
  program.add_option("--compiler", options.compiler, "g++ or clang++")->capture_default_str();
  program.add_option("--only", options.only, "only this problem");
  program.add_option("--values", options.plan.values, "length of the arrays")
      ->check(CLI::Range(8, 1 << 20))
      ->capture_default_str();
  program.add_option("--seconds", options.plan.seconds, "for a problem in one mode")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  program.add_flag("--markdown", options.markdown, "tables for docs/benchmarks.md");
  program.add_option("--json", options.json, "also write all figures to this file");
  try {
    program.parse(count, words);
  } catch (const CLI::ParseError& error) {
    std::exit(program.exit(error) == 0 ? 0 : 2);
  }
  return options;
}

std::vector<Problem> chosen_problems(const Options& options) {
  std::vector<Problem> chosen;
  std::string known;
  for (Problem& problem : all_problems()) {
    known += (known.empty() ? "" : ", ") + problem.name;
    if (options.only.empty() || problem.name == options.only) chosen.push_back(std::move(problem));
  }
  if (chosen.empty())
    throw vcrit::InputError({"--only"}, "\"" + options.only + "\"", "one of " + known);
  return chosen;
}

void run(const Options& options) {
  const std::vector<Problem> problems = chosen_problems(options);
  const std::filesystem::path compiler = compiler_named(options.compiler);
  const vcrit::validation::PrivateFolder folder;
  Comparison all;
  all.compiler = vcrit::validation::describe_compiler(compiler, folder.path());
  all.plan = options.plan;
  for (const Problem& problem : problems) {
    fmt::print(stderr, "{}\n", problem.name);
    all.problems.push_back(problem.name);
    const std::vector<Evaluator> methods = evaluators(problem, compiler, all.missing);
    for (const Mode mode : both_modes)
      for (Result& each : measure(problem, mode, methods, options.plan))
        all.results.push_back(std::move(each));
  }
  fmt::print("{}", heading(all));
  for (const Mode mode : both_modes)
    fmt::print("{}", table(all, mode, options.markdown ? Style::markdown : Style::text));
  fmt::print("{}", notes(all));
  if (!options.json.empty()) vcrit::write_file(options.json, as_json(all).dump(1) + "\n");
}

}  // namespace

int main(int count, char** words) {
  const Options options = parsed(count, words);
  try {
    run(options);
    return 0;
  } catch (const vcrit::InputError& error) {
    fmt::print(stderr, "vcrit_speed: {}\n", error.what());
    return 2;
  }
}
