// Error against run time of all methods on the reference table, in one run.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "harness/commands.hpp"
#include "simulators/tables.hpp"

namespace vcrit::bench {

namespace {

using namespace simulators;

struct SimulatorOptions {
  std::string table = VCRIT_REFERENCE_TABLE, problem, json;
  Budget budget;
  std::size_t every = 1;
  bool quick = false;
};

std::vector<Case> chosen_cases(const SimulatorOptions& options) {
  std::vector<Case> chosen;
  std::size_t number = 0;
  for (Case& row : read_cases(options.table))
    if ((options.problem.empty() || row.problem == options.problem) &&
        number++ % options.every == 0)
      chosen.push_back(std::move(row));
  if (chosen.empty())
    throw InputError({"--problem"}, "\"" + options.problem + "\"", "P1, P2 or P3");
  return chosen;
}

void run_simulators(const SimulatorOptions& options) {
  const std::vector<Case> cases = chosen_cases(options);
  const std::vector<Peer> peers = all_peers(options.quick);
  std::size_t done = 0;
  const std::vector<PeerSolve> points =
      measure(cases, peers, options.budget, [&](const std::string& name) {
        fmt::print(stderr, "{}/{} {}\n", ++done, cases.size(), name);
      });
  const auto machine = benchmark_machine();
  for (const std::string& problem : problems(cases))
    fmt::print("{}",
               work_precision_table(
                   work_precision(points, [&](const Case& row) { return row.problem == problem; }),
                   problem));
  fmt::print("{}{}{}", summary_table(cases, points), reduced_model_table(), machine_lines(machine));
  if (!options.json.empty())
    write_file(options.json, as_json(points, machine, options.budget) + "\n");
}

}  // namespace

void add_simulators(CLI::App& program, int&) {
  const auto options = std::make_shared<SimulatorOptions>();
  CLI::App& command = *program.add_subcommand(
      "simulators", "Error against run time of all methods for steady stick-slip motion.");
  command.add_option("--table", options->table, "reference table (CSV)")->capture_default_str();
  command.add_option("--problem", options->problem, "only this one: P1, P2 or P3");
  const CLI::Option* const budget =
      command.add_option("--budget", options->budget.solve, "seconds a solve may take")
          ->check(CLI::PositiveNumber)
          ->capture_default_str();
  const CLI::Option* const every =
      command.add_option("--every", options->every, "only every N-th row")
          ->check(CLI::PositiveNumber);
  command.add_flag("--quick", options->quick,
                   "fewer rows and settings, 0.1 s a solve: half a minute");
  command.add_option("--json", options->json, "also write all points to this file");
  command.callback([=] {
    if (options->quick && budget->count() == 0) options->budget = {0.1, 0.002};
    if (options->quick && every->count() == 0) options->every = 3;
    run_simulators(*options);
  });
}

}  // namespace vcrit::bench
