// The benchmarks by name: each adds its command to the program.
#pragma once

namespace CLI {
class App;
}

namespace vcrit::bench {

/// `status` is the program's exit status, where a command has more than one.
void add_simulators(CLI::App& program, int& status);
void add_masses(CLI::App& program, int& status);
void add_derivation(CLI::App& program, int& status);
void add_bounds(CLI::App& program, int& status);
void add_evaluators(CLI::App& program, int& status);

}  // namespace vcrit::bench
