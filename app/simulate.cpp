// vcrit simulate: the steady stick-slip motion at one speed.
#include <fmt/core.h>

#include <memory>
#include <numbers>
#include <optional>

#include "commands.hpp"
#include "method_choice.hpp"
#include "options.hpp"
#include "record/fields.hpp"
#include "report/records.hpp"
#include "rules/rulebook.hpp"
#include "simulate_indenter.hpp"
#include "simulation/steady/energy.hpp"
#include "simulation/steady/exact.hpp"
#include "simulation/steady/normal_force.hpp"
#include "speed_options.hpp"

namespace vcrit::record {

void fields(Fields& f, const simulation::EnergyBalance& it) {
  f("drive", it.drive)("friction", it.friction)("dampers", it.dampers)("error", it.error);
}

void fields(Fields& f, const simulation::OtherStart& it) {
  f("friction_ratio", it.friction_ratio)("friction_ratio_error", it.friction_ratio_error);
  f("regime", it.regime);
}

}  // namespace vcrit::record

namespace vcrit::app {

namespace {

using simulation::EnergyBalance;
using simulation::SteadyState;

struct SimulateOptions {
  SceneOptions scene;
  SpeedOptions speed;
  MethodChoice method;
  bool json = false;
};

// Where the contact opens.
struct Separated {
  double mean_normal_force;  // N
  simulation::OtherStart other_start;

  friend void fields(record::Fields& f, const Separated& it) {
    f("mean_normal_force", it.mean_normal_force)("other_start", it.other_start);
    f("starts_agree", it.other_start.agrees);
  }
};

// Separation and energy are known for the exact method alone.
struct SimulationAnswer {
  Speed speed;
  SteadyState steady;
  std::string method;
  std::vector<std::string> warnings;
  std::optional<EnergyBalance> energy = {};
  std::optional<Separated> separation = {};
  std::optional<IndenterAnswer> indenter = {};

  friend void fields(record::Fields& f, const SimulationAnswer& it) {
    const SteadyState& steady = it.steady;
    f("velocity", it.speed.velocity)("velocity_ratio", it.speed.ratio);
    f("friction_ratio", steady.friction_ratio)("friction_ratio_error", steady.friction_ratio_error);
    f("regime", steady.regime)("method", it.method)("periods", steady.periods);
    f("events", steady.events).some("energy", it.energy).some("separation", it.separation);
    f.some("indenter", it.indenter).some("warnings", it.warnings);
  }
};

void print_velocity(const Speed& speed) {
  fmt::print("velocity        {} m/s ({:.6g} v*)\n", speed.velocity, speed.ratio);
}

// omega: rad/s
void print_simulate_text(const SimulationAnswer& answer, double omega) {
  const SteadyState& steady = answer.steady;
  print_velocity(answer.speed);
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
  if (!answer.separation) return;
  fmt::print("normal force    {:.6g} N on average, while the contact opens in each period\n",
             answer.separation->mean_normal_force);
  const simulation::OtherStart& other = answer.separation->other_start;
  if (other.agrees)
    fmt::print("starts          agree, in sliding and at rest\n");
  else
    fmt::print("starts          DISAGREE: the other one ends in {}, {}\n", other.friction_ratio,
               to_text(other.regime));
}

SimulationAnswer answer_of(const SimulateOptions& options, const Problem& problem,
                           const simulation::System& system) {
  const Speed speed = options.speed.of(problem);
  SimulationAnswer answer{speed, options.method.steady_state(system, speed.velocity),
                          options.method.name(), problem->source->warnings};
  if (!options.method.is_exact()) return answer;
  answer.energy = simulation::energy_balance(system, speed.velocity);
  if (const auto& other = answer.steady.other_start)
    answer.separation = {simulation::mean_normal_force(system), *other};
  return answer;
}

// Of the whole; what the cells do is told beside it.
SimulationAnswer answer_below_indenter(const SimulateOptions& options, const Problem& problem) {
  if (!options.method.is_exact())
    rules::require(rules::Question::other_methods, problem, options.method.name() + " ");
  const Speed speed = options.speed.of(problem);
  const IndenterAnswer cells = simulate_indenter(problem, speed.velocity);
  SimulationAnswer answer{speed, indenter::steady_state_of(cells.friction), options.method.name(),
                          problem->source->warnings};
  answer.indenter = cells;
  return answer;
}

void simulate_below_indenter(const SimulateOptions& options, const Problem& problem) {
  const SimulationAnswer answer = answer_below_indenter(options, problem);
  if (options.json) return print(record::json_of(answer));
  print_velocity(answer.speed);
  print_indenter(*answer.indenter);
}

void simulate(const SimulateOptions& options) {
  const Problem problem = options.scene.read();
  if (problem->indenter) return simulate_below_indenter(options, problem);
  const simulation::System system = simulation::system_of(problem);
  const SimulationAnswer answer = answer_of(options, problem, system);
  if (options.json)
    print(record::json_of(answer));
  else
    print_simulate_text(answer, system.omega);
}

}  // namespace

void add_simulate(CLI::App& program) {
  const auto options = std::make_shared<SimulateOptions>();
  CLI::App* command = program.add_subcommand("simulate", "Simulate stick-slip at one speed");
  options->scene.add_to(*command);
  options->speed.add_to(*command);
  options->method.add_to(*command);
  command->add_flag("--json", options->json, "print one JSON object");
  command->callback([options] { simulate(*options); });
}

}  // namespace vcrit::app
