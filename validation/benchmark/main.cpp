// vcrit_benchmark: error against run time of all methods on the reference table, in one run.
// Tables on stdout, progress on stderr.
#include <fmt/core.h>

#include <CLI/CLI.hpp>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "benchmark/tables.hpp"

namespace {

using namespace vcrit::benchmark;

struct Options {
  std::string table = VCRIT_REFERENCE_TABLE, problem, json;
  Budget budget;
  std::size_t every = 1;
  bool quick = false;
};

Options parsed(int count, char** words) {
  CLI::App program("Error against run time of all methods for steady stick-slip motion.");
  Options options;
  program.add_option("--table", options.table, "reference table (CSV)")->capture_default_str();
  program.add_option("--problem", options.problem, "only this one: P1, P2 or P3");
  program.add_option("--budget", options.budget.solve, "seconds a solve may take")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  program.add_option("--every", options.every, "only every N-th row")->check(CLI::PositiveNumber);
  program.add_flag("--quick", options.quick,
                   "fewer rows and settings, 0.1 s a solve: half a minute");
  program.add_option("--json", options.json, "also write all points to this file");
  try {
    program.parse(count, words);
  } catch (const CLI::ParseError& error) {
    std::exit(program.exit(error) == 0 ? 0 : 2);
  }
  if (options.quick && program["--budget"]->count() == 0) options.budget = {0.1, 0.002};
  if (options.quick && program["--every"]->count() == 0) options.every = 3;
  return options;
}

std::vector<Case> chosen_cases(const Options& options) {
  std::vector<Case> chosen;
  std::size_t number = 0;
  for (Case& row : read_cases(options.table))
    if ((options.problem.empty() || row.problem == options.problem) &&
        number++ % options.every == 0)
      chosen.push_back(std::move(row));
  if (chosen.empty())
    throw vcrit::InputError({"--problem"}, "\"" + options.problem + "\"", "P1, P2 or P3");
  return chosen;
}

void run(const Options& options) {
  const std::vector<Case> cases = chosen_cases(options);
  const std::vector<Peer> peers = all_peers(options.quick);
  std::size_t done = 0;
  const std::vector<Point> points =
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
    vcrit::write_file(options.json, as_json(points, machine, options.budget).dump(1) + "\n");
}

}  // namespace

int main(int count, char** words) {
  const Options options = parsed(count, words);
  try {
    run(options);
    return 0;
  } catch (const vcrit::InputError& error) {
    fmt::print(stderr, "vcrit_benchmark: {}\n", error.what());
    return 2;
  }
}
