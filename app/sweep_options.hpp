// The command `sweep` as it is written: known to `vcrit`, which tells of it and starts the program
// that sweeps, and to that program.
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

}  // namespace vcrit::app
