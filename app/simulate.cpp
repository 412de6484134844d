// vcrit simulate: the steady stick-slip motion at one speed.
#include <fmt/core.h>

#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <optional>

#include "answers/critical_onset.hpp"
#include "base/units.hpp"
#include "commands.hpp"
#include "method_choice.hpp"
#include "options.hpp"
#include "rules/rulebook.hpp"
#include "simulate_indenter.hpp"
#include "simulation/steady/energy.hpp"
#include "simulation/steady/exact.hpp"
#include "simulation/steady/normal_force.hpp"

namespace vcrit::app {

namespace {

using simulation::EnergyBalance;
using simulation::SteadyState;

struct SimulateOptions {
  SceneOptions scene;
  std::string velocity;
  std::optional<double> velocity_ratio;
  MethodChoice method;
  bool json = false;
};

struct Speed {
  double velocity, ratio;
};

Speed speed_of(const SimulateOptions& options, const Problem& problem) {
  const CriticalOnset onset = critical_onset(problem);
  const double critical = onset.contact_velocity;
  if (options.velocity_ratio && std::isinf(critical))
    throw ModelError(onset.reason + ": --velocity-ratio has no meaning, give --velocity");
  const double velocity =
      options.velocity_ratio
          ? *options.velocity_ratio * critical
          : parse_quantity(options.velocity, Dimension::velocity, {"--velocity"});
  if (!(velocity > 0 && std::isfinite(velocity)))
    throw InputError({options.velocity_ratio ? "--velocity-ratio" : "--velocity"},
                     fmt::format("a speed of {} m/s", velocity), "a finite speed above 0");
  return {velocity, velocity / critical};
}

// Where the surfaces part.
struct Parting {
  double mean_normal_force;  // N
  simulation::OtherStart other_start;
};

// Parting and energy are known for the exact method alone.
struct SimulationAnswer {
  SteadyState steady;
  std::optional<EnergyBalance> energy;
  std::optional<Parting> parting;
};

SimulationAnswer answer_of(const SimulateOptions& options, const simulation::System& system,
                           double velocity) {
  SimulationAnswer answer{options.method.steady_state(system, velocity), {}, {}};
  if (!options.method.is_exact()) return answer;
  answer.energy = simulation::energy_balance(system, velocity);
  if (const auto& other = answer.steady.other_start)
    answer.parting = {simulation::mean_normal_force(system), *other};
  return answer;
}

nlohmann::ordered_json parting_json(const SimulationAnswer& answer) {
  const simulation::OtherStart& other = answer.parting->other_start;
  return {{"mean_normal_force", answer.parting->mean_normal_force},
          {"other_start",
           {{"friction_ratio", other.friction_ratio},
            {"friction_ratio_error", json_number(other.friction_ratio_error)},
            {"regime", to_text(other.regime)}}},
          {"starts_agree", other.agrees}};
}

nlohmann::ordered_json answer_json(const Speed& speed, const SimulationAnswer& answer,
                                   const std::string& method) {
  const SteadyState& steady = answer.steady;
  nlohmann::ordered_json events = nlohmann::ordered_json::array();
  for (const simulation::Event& event : steady.events)
    events.push_back({{"phase", event.phase}, {"to", to_text(event.to)}});
  nlohmann::ordered_json periods = nullptr;
  if (steady.periods) periods = *steady.periods;
  nlohmann::ordered_json object{{"velocity", speed.velocity},
                                {"velocity_ratio", json_number(speed.ratio)},
                                {"friction_ratio", steady.friction_ratio},
                                {"friction_ratio_error", json_number(steady.friction_ratio_error)},
                                {"regime", to_text(steady.regime)},
                                {"method", method},
                                {"periods", periods},
                                {"events", events}};
  if (answer.energy)
    object["energy"] = {{"drive", answer.energy->drive},
                        {"friction", answer.energy->friction},
                        {"dampers", answer.energy->dampers},
                        {"error", json_number(answer.energy->error)}};
  if (answer.parting) object["separation"] = parting_json(answer);
  return object;
}

void print_velocity(const Speed& speed) {
  fmt::print("velocity        {} m/s ({:.6g} v*)\n", speed.velocity, speed.ratio);
}

// omega: rad/s
void print_simulate_text(const Speed& speed, const SimulationAnswer& answer, double omega) {
  const SteadyState& steady = answer.steady;
  print_velocity(speed);
  fmt::print("friction ratio  {} (error about {:.1g})\n", steady.friction_ratio,
             steady.friction_ratio_error);
  fmt::print("regime          {}\n", to_text(steady.regime));
  for (const simulation::Event& event : steady.events)
    fmt::print("  at phase {:<20.15g} to {}\n", event.phase, to_text(event.to));
  if (!answer.energy) return;
  const double frequency = omega / (2 * std::numbers::pi);
  fmt::print("power of drive  {:.6g} W: friction {:.6g} W, dampers {:.6g} W\n",
             answer.energy->drive * frequency, answer.energy->friction * frequency,
             answer.energy->dampers * frequency);
  if (!answer.parting) return;
  fmt::print("normal force    {:.6g} N on average, while the surfaces part in each period\n",
             answer.parting->mean_normal_force);
  if (answer.parting->other_start.agrees)
    fmt::print("starts          agree, in sliding and at rest\n");
  else
    fmt::print("starts          DISAGREE: the other one ends in {}, {}\n",
               answer.parting->other_start.friction_ratio,
               to_text(answer.parting->other_start.regime));
}

// Of the whole; what the cells do is told beside it.
void simulate_below_indenter(const SimulateOptions& options, const Problem& problem) {
  if (!options.method.is_exact())
    rules::require(rules::Question::other_methods, problem, options.method.name() + " ");
  const Speed speed = speed_of(options, problem);
  const IndenterAnswer answer = simulate_indenter(problem, speed.velocity);
  const SimulationAnswer whole{indenter::steady_state_of(answer.friction), {}, {}};
  if (options.json) {
    nlohmann::ordered_json object = answer_json(speed, whole, options.method.name());
    object["indenter"] = to_json(answer);
    return print(with_warnings(object, problem->source->warnings));
  }
  print_velocity(speed);
  print_indenter(answer);
}

void simulate(const SimulateOptions& options) {
  const Problem problem = options.scene.read();
  if (problem->indenter) return simulate_below_indenter(options, problem);
  const simulation::System system = simulation::system_of(problem);
  const Speed speed = speed_of(options, problem);
  const SimulationAnswer answer = answer_of(options, system, speed.velocity);
  if (options.json)
    print(with_warnings(answer_json(speed, answer, options.method.name()),
                        problem->source->warnings));
  else
    print_simulate_text(speed, answer, system.omega);
}

}  // namespace

void add_simulate(CLI::App& program) {
  const auto options = std::make_shared<SimulateOptions>();
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
