// The command `sweep`, as it is written and what it does: for `vcrit`, and for the program that it
// becomes for arrays.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "maps/stream.hpp"
#include "options.hpp"

namespace CLI {
class App;
}

namespace vcrit::app {

struct SweepOptions {
  SceneOptions scene;
  std::vector<std::string> over;
  std::vector<std::string> quantities;
  std::string velocity, velocity_ratio, out;
  maps::StreamOptions stream;
  bool units = false, json = false;
};

/// Registers the command; `run` is its callback.
void add_sweep(CLI::App& program, std::function<void(const SweepOptions&)> run);

/// Prints the table, or writes the file together with the other ranks.
void run_sweep(const SweepOptions& options, maps::Ranks& ranks);

}  // namespace vcrit::app
