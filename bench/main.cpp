// vcrit_bench: what the project measures, one command each. Tables on stdout, progress on stderr;
// exit status 2 on wrong input.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "base/errors.hpp"
#include "harness/commands.hpp"

int main(int count, char** words) {
  using namespace vcrit::bench;
  CLI::App program("Benchmarks of vcrit and of what else one could take.");
  program.require_subcommand(1);
  // A benchmark takes minutes: a line is shown when it is there.
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  int status = 0;
  for (const auto add : {add_simulators, add_masses, add_derivation, add_bounds, add_evaluators})
    add(program, status);
  try {
    program.parse(count, words);
    return status;
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? 0 : 2;
  } catch (const vcrit::InputError& error) {
    fmt::print(stderr, "vcrit_bench: {}\n", error.what());
    return 2;
  }
}
