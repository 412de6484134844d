// The commands of the program, one file each. Each function registers its command with a callback
// that prints the result on stdout and may set the exit status.
#pragma once

#include <string>

#include "problem/problem.hpp"

namespace CLI {
class App;
}

namespace vcrit::app {

/// Pages that know the report; without them there are no such options.
struct DerivePages {
  std::string (*catalogue)();               ///< of --catalogue
  std::string (*material)(const Problem&);  ///< of --material
};
void add_derive(CLI::App& program, int& status, const DerivePages* pages);
void add_eval(CLI::App& program);
void add_generate(CLI::App& program);
void add_simulate(CLI::App& program);
void add_critical(CLI::App& program, int& status);
/// `argv` as the program got it: for another one, which writes arrays.
void add_sweep(CLI::App& program, char** argv);
void add_plot(CLI::App& program);
void add_explore(CLI::App& program);
void add_solve(CLI::App& program);
void add_fit(CLI::App& program);
void add_new(CLI::App& program);
void add_check(CLI::App& program, int& status);
void add_validate(CLI::App& program, int& status);

}  // namespace vcrit::app
