// The commands of the program, one file each. Each function registers its command with a callback
// that prints the result on stdout and may set the exit status.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace vcrit::app {

/// `catalogue` makes the page of --catalogue; without it there is no such option.
void add_derive(CLI::App& program, int& status, std::string (*catalogue)());
void add_eval(CLI::App& program);
void add_generate(CLI::App& program);
void add_simulate(CLI::App& program);
void add_critical(CLI::App& program, int& status);
/// `argv` as the program got it: for another one, which sweeps.
void add_sweep(CLI::App& program, char** argv);
void add_plot(CLI::App& program);
void add_solve(CLI::App& program);
void add_fit(CLI::App& program);
void add_validate(CLI::App& program, int& status);

}  // namespace vcrit::app
