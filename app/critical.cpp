// vcrit critical: v* by the formula against v* by simulation.
#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "commands.hpp"
#include "critical/certified.hpp"
#include "options.hpp"
#include "simulation/steady/exact.hpp"

namespace vcrit::app {

namespace {

// Both ways lose at most the condition number of the scene times a few units in the last place;
// 1e-9 leaves room for scenes within 1e-6 of resonance.
constexpr double tolerance = 1e-9;

}  // namespace

void add_critical(CLI::App& program, int& status) {
  struct Options {
    SceneOptions scene;
    bool json = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("critical", "Critical velocity: formula against simulation");
  options->scene.add_to(*command);
  command->add_flag("--json", options->json, "print one JSON object");
  command->callback([options, &status] {
    const Scene scene = options->scene.read();
    const simulation::System system = simulation::system_of(scene);
    const auto [formula, bound, reason] = certified_critical_velocity(scene);
    if (std::isinf(formula)) throw ModelError(reason + ": nothing to compare");
    const double simulated = simulation::sliding_threshold(system).contact_velocity;
    const double difference = formula == simulated ? 0 : std::abs(simulated - formula) / formula;
    if (!(difference <= tolerance)) status = 1;
    if (options->json)
      return print({{"formula", number(formula)},
                    {"simulated", number(simulated)},
                    {"relative_difference", number(difference)},
                    {"tolerance", tolerance},
                    {"agree", status == 0}});
    fmt::print("formula     {} m/s\nsimulated   {} m/s\ndifference  {:.2g} (relative; {} {:g})\n",
               formula, simulated, difference, status == 0 ? "below" : "ABOVE", tolerance);
  });
}

}  // namespace vcrit::app
