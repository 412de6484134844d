// vcrit simulate: the steady stick-slip motion at one speed.
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <optional>

#include "base/units.hpp"
#include "commands.hpp"
#include "critical/certified.hpp"
#include "method_choice.hpp"
#include "options.hpp"
#include "simulation/steady/energy.hpp"

namespace vcrit::app {

namespace {

using simulation::EnergyBalance;
using simulation::SteadyState;

struct Options {
  SceneOptions scene;
  std::string velocity;
  std::optional<double> velocity_ratio;
  MethodChoice method;
  bool json = false;
};

struct Speed {
  double velocity, ratio;
};

Speed speed_of(const Options& options, const Scene& scene) {
  const auto [critical, bound, reason] = certified_critical_velocity(scene);
  if (options.velocity_ratio && std::isinf(critical))
    throw ModelError(reason + ": --velocity-ratio has no meaning, give --velocity");
  const double velocity =
      options.velocity_ratio
          ? *options.velocity_ratio * critical
          : parse_quantity(options.velocity, Dimension::velocity, {"--velocity"});
  if (!(velocity > 0 && std::isfinite(velocity)))
    throw InputError({options.velocity_ratio ? "--velocity-ratio" : "--velocity"},
                     fmt::format("a speed of {} m/s", velocity), "a finite speed above 0");
  return {velocity, velocity / critical};
}

// The energy is known for the exact method alone.
void print_json(const Speed& speed, const SteadyState& steady,
                const std::optional<EnergyBalance>& energy, const std::string& method) {
  nlohmann::ordered_json events = nlohmann::ordered_json::array();
  for (const simulation::Event& event : steady.events)
    events.push_back({{"phase", event.phase}, {"to", to_text(event.to)}});
  nlohmann::ordered_json periods = nullptr;
  if (steady.periods) periods = *steady.periods;
  nlohmann::ordered_json object{{"velocity", speed.velocity},
                                {"velocity_ratio", number(speed.ratio)},
                                {"friction_ratio", steady.friction_ratio},
                                {"friction_ratio_error", number(steady.friction_ratio_error)},
                                {"regime", to_text(steady.regime)},
                                {"method", method},
                                {"periods", periods},
                                {"events", events}};
  if (energy)
    object["energy"] = {{"drive", energy->drive},
                        {"friction", energy->friction},
                        {"dampers", energy->dampers},
                        {"error", number(energy->error)}};
  print(object);
}

// omega: rad/s
void print_text(const Speed& speed, const SteadyState& steady,
                const std::optional<EnergyBalance>& energy, double omega) {
  fmt::print("velocity        {} m/s ({:.6g} v*)\n", speed.velocity, speed.ratio);
  fmt::print("friction ratio  {} (error about {:.1g})\n", steady.friction_ratio,
             steady.friction_ratio_error);
  fmt::print("regime          {}\n", to_text(steady.regime));
  for (const simulation::Event& event : steady.events)
    fmt::print("  at phase {:<20.15g} to {}\n", event.phase, to_text(event.to));
  if (!energy) return;
  const double frequency = omega / (2 * std::numbers::pi);
  fmt::print("power of drive  {:.6g} W: friction {:.6g} W, dampers {:.6g} W\n",
             energy->drive * frequency, energy->friction * frequency, energy->dampers * frequency);
}

void simulate(const Options& options) {
  const Scene scene = options.scene.read();
  const simulation::System system = simulation::system_of(scene);
  const Speed speed = speed_of(options, scene);
  const SteadyState steady = options.method.steady_state(system, speed.velocity);
  std::optional<EnergyBalance> energy;
  if (options.method.is_exact()) energy = simulation::energy_balance(system, speed.velocity);
  if (options.json)
    print_json(speed, steady, energy, options.method.name());
  else
    print_text(speed, steady, energy, system.omega);
}

}  // namespace

void add_simulate(CLI::App& program) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("simulate", "Simulate stick-slip at one speed");
  options->scene.add_to(*command);
  CLI::Option_group* speed = command->add_option_group("speed");
  speed->add_option("--velocity", options->velocity,
                    "mean velocity of the drive: 0.02 or \"20 mm/s\"");
  speed->add_option("--velocity-ratio", options->velocity_ratio, "the same in units of v*");
  speed->require_option(1);
  options->method.add_to(*command);
  command->add_flag("--json", options->json, "print one JSON object");
  command->callback([options] { simulate(*options); });
}

}  // namespace vcrit::app
