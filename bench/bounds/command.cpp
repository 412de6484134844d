// Whether the error bounds of generated evaluators hold, on random cases of every kind and size,
// beside ball arithmetic. Exit status 1 on a violation.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <memory>
#include <thread>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "bounds/tables.hpp"
#include "harness/commands.hpp"
#include "run/compiler.hpp"

namespace vcrit::bench {

namespace {

using namespace bounds;

struct BoundsOptions {
  TrialOptions trial{.threads = std::max(1U, std::thread::hardware_concurrency())};
  std::vector<std::string> only;
  std::string json;
  bool markdown = false;
};

std::vector<TrialSystem> chosen_systems(const std::vector<std::string>& only) {
  std::vector<TrialSystem> all = all_systems(), chosen;
  if (only.empty()) return all;
  for (const std::string& name : only) {
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const TrialSystem& system) { return system.name == name; });
    if (found == all.end())
      throw InputError({"--only"}, "\"" + name + "\"",
                       "a system as in the table without this option");
    chosen.push_back(*found);
  }
  return chosen;
}

int run_bounds(const BoundsOptions& options) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  const std::vector<TrialSystem> systems = chosen_systems(options.only);
  std::vector<validation::PrivateFolder> folders(systems.size());
  std::vector<CompiledHeader> evaluators;
  for (std::size_t i = 0; i < systems.size(); ++i)
    evaluators.emplace_back(systems[i], header_for(systems[i]), folders[i].path());
  in_parallel(systems.size(), options.trial.threads,
              [&](std::size_t i) { evaluators[i].compile(); });
  std::vector<SystemResult> results;
  for (std::size_t i = 0; i < systems.size(); ++i) {
    fmt::print(stderr, "{}\n", systems[i].name);
    results.push_back({systems[i].name, try_cases(systems[i], evaluators[i], options.trial)});
  }
  fmt::print("{}", tables(results, options.markdown ? TableStyle::markdown : TableStyle::text));
  fmt::print(stderr, "{:.0f} s\n", std::chrono::duration<double>(Clock::now() - start).count());
  if (!options.json.empty()) write_file(options.json, as_json(results, options.trial) + "\n");
  const std::string violations = first_violations(results);
  fmt::print(stderr, "{}", violations);
  return violations.empty() ? 0 : 1;
}

}  // namespace

void add_bounds(CLI::App& program, int& status) {
  const auto options = std::make_shared<BoundsOptions>();
  CLI::App& command = *program.add_subcommand(
      "bounds", "Error bounds of generated evaluators, tried on random cases.");
  command.add_option("--cases", options->trial.cases, "cases of each system")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command.add_option("--only", options->only, "only these systems");
  command.add_option("--seed", options->trial.seed, "of the random cases")->capture_default_str();
  command.add_option("--json", options->json, "also write all counts to this file");
  command.add_flag("--markdown", options->markdown, "tables for a document");
  command.callback([options, &status] { status = run_bounds(*options); });
}

}  // namespace vcrit::bench
