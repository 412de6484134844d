// vcrit simulate: the steady stick-slip motion at one speed.
#include <fmt/core.h>

#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "answers/realised_friction.hpp"
#include "answers/under_load.hpp"
#include "commands.hpp"
#include "friction_words.hpp"
#include "method_choice.hpp"
#include "options.hpp"
#include "record/fields.hpp"
#include "report/records.hpp"
#include "rules/kinds.hpp"
#include "rules/rulebook.hpp"
#include "simulate_indenter.hpp"
#include "simulation/steady/energy.hpp"
#include "simulation/steady/exact.hpp"
#include "simulation/steady/mass_amplitudes.hpp"
#include "simulation/steady/normal_force.hpp"
#include "speed_options.hpp"
#include "streams.hpp"

namespace vcrit::record {

void fields(Fields& f, const simulation::EnergyBalance& it) {
  f("drive", it.drive)("friction", it.friction)("dampers", it.dampers)("error", it.error);
}

void fields(Fields& f, const simulation::OtherStart& it) {
  f("friction_ratio", it.friction_ratio)("friction_ratio_error", it.friction_ratio_error);
  f("regime", it.regime);
}

void fields(Fields& f, const RealisedFriction& it) {
  f("pairs", it.pairs)("misfit", it.misfit)("misfit_at_omega", it.misfit_at_omega);
  f("critical_velocity", it.critical_velocity)("outside", it.outside)("error", it.error);
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
  int digits = few_digits;
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

// By the names that the scene gives the masses.
struct Masses {
  std::vector<std::pair<std::string, double>> amplitudes;  // m

  bool empty() const { return amplitudes.empty(); }
  friend void fields(record::Fields& f, const Masses& it) {
    for (const auto& [name, amplitude] : it.amplitudes) f(name.c_str(), amplitude);
  }
};

// Separation, energy and masses are known for the exact method alone.
struct SimulationAnswer {
  Speed speed;
  SteadyState steady;
  std::string method;
  std::vector<std::string> warnings;
  std::optional<EnergyBalance> energy = {};
  std::optional<Separated> separation = {};
  std::optional<IndenterAnswer> indenter = {};
  Masses masses = {};
  std::optional<UnderLoad> load = {};
  std::optional<RealisedFriction> realisation = {};
  std::optional<BelowMount> mount = {};

  friend void fields(record::Fields& f, const SimulationAnswer& it) {
    const SteadyState& state = it.steady;
    f("velocity", it.speed.velocity)("velocity_ratio", it.speed.ratio);
    f("friction_ratio", state.friction_ratio)("friction_ratio_error", state.friction_ratio_error);
    f("regime", state.regime)("method", it.method)("periods", state.periods);
    f("events", state.events).some("energy", it.energy).some("separation", it.separation);
    if (it.load) fields(f, *it.load);
    if (it.mount) fields(f, *it.mount);
    if (it.indenter && it.indenter->on_drive)
      f("cells", it.indenter->friction.cells)("cells_error", it.indenter->friction.error);
    f.some("indenter", it.indenter).some("masses", it.masses);
    f.some("realisation", it.realisation).some("warnings", it.warnings);
  }
};

const char* event_words(simulation::Motion to) {
  switch (to) {
    case simulation::Motion::slip:
      return "the contact starts to slide";
    case simulation::Motion::stick:
      return "the contact sticks";
    case simulation::Motion::backslip:
      return "the contact slips backward";
    case simulation::Motion::separated:
      return "the contact opens";
  }
  throw Bug("an event without words");
}

void print_events(const SteadyState& steady, const char* first, int digits) {
  const char* heading = "one cycle";
  if (steady.periods.value_or(1) > 1) {
    print_row(heading, fmt::format("repeats after {} periods of vibration", *steady.periods));
    heading = "";
  }
  for (const simulation::Event& event : steady.events)
    print_row(
        std::exchange(heading, ""),
        fmt::format("at {:>7}°  {}", rounded(event.phase * 180 / std::numbers::pi, "", digits),
                    event_words(event.to)));
  if (!steady.events.empty()) print_row("", fmt::format("(0° is the {})", first));
}

// omega: rad/s
void print_power(const EnergyBalance& energy, double omega, int digits) {
  const double frequency = omega / (2 * std::numbers::pi);
  const auto watts = [&](double joules) { return rounded(joules * frequency, "W", digits); };
  print_row("power of drive", fmt::format("{}: friction {}, dampers {}", watts(energy.drive),
                                          watts(energy.friction), watts(energy.dampers)));
}

void print_starts(const simulation::OtherStart& other, int digits) {
  print_row("starts",
            other.agrees
                ? "from rest and from sliding, the motion becomes the same"
                : fmt::format("DISAGREE: the other start leads to a friction ratio of {}, {}",
                              friction_ratio_words(other.friction_ratio, other.friction_ratio_error,
                                                   digits),
                              regime_words(other.regime)));
}

void print_load(const std::optional<UnderLoad>& load, int digits) {
  if (load && load->indentation)
    print_row("mean indentation", rounded(*load->indentation, "m", digits));
  if (load && load->sinking_velocity)
    print_row("mean indentation", fmt::format("none: the contact sinks at {}",
                                              rounded(*load->sinking_velocity, "m/s", digits)));
}

void print_realisation(const RealisedFriction& found, int digits) {
  print_row("drive", fmt::format("{} pairs fitted to the table, misfit {:.2g} %", found.pairs,
                                 100 * found.misfit));
  print_row("", fmt::format("v* of the fit {}, its part of the error {:.1g}",
                            rounded(found.critical_velocity, "m/s", digits), found.error));
}

void print_simulate_text(const SimulationAnswer& answer, const Problem& problem,
                         const simulation::System& system, int digits) {
  const SteadyState& steady = answer.steady;
  print_friction(problem, answer.speed,
                 {steady.friction_ratio, steady.friction_ratio_error,
                  simulation::mean_normal_force(system), steady.regime},
                 digits);
  print_load(answer.load, digits);
  print_events(
      steady, system.opening && problem->mount ? "vibrator's deepest place" : "deepest indentation",
      digits);
  if (answer.realisation) print_realisation(*answer.realisation, digits);
  if (answer.energy) print_power(*answer.energy, system.omega, digits);
  if (answer.separation) print_starts(answer.separation->other_start, digits);
}

void add_realisation(const Problem& problem, double velocity, SimulationAnswer& answer) {
  answer.realisation = realised_friction(problem, velocity);
  answer.steady.friction_ratio_error += answer.realisation->error;
  for (const std::string& each : answer.realisation->warnings) {
    warn(each);
    answer.warnings.push_back(each);
  }
}

SimulationAnswer answer_of(const SimulateOptions& options, const Problem& problem,
                           const simulation::System& system) {
  if (!options.method.is_exact())
    rules::require(rules::Question::other_methods, problem, options.method.name() + " ");
  const Speed speed = options.speed.of(problem);
  SimulationAnswer answer{speed, options.method.steady_state(system, speed.velocity),
                          options.method.name(), problem->source->warnings};
  answer.load = under_load(problem);
  answer.mount = below_mount(problem);
  if (problem->receptance() != nullptr) add_realisation(problem, speed.velocity, answer);
  if (!options.method.is_exact()) return answer;
  answer.energy = simulation::energy_balance(system, speed.velocity);
  for (const auto& [symbol, amplitude] : simulation::mass_amplitudes(system, speed.velocity))
    answer.masses.amplitudes.emplace_back(to_text(as_called(problem, symbol)), amplitude);
  if (const auto& other = answer.steady.other_start)
    answer.separation = {simulation::mean_normal_force(system), *other};
  return answer;
}

// Friction of the whole contact, with what its cells do.
SimulationAnswer answer_below_indenter(const SimulateOptions& options, const Problem& problem) {
  if (!options.method.is_exact())
    rules::require(rules::Question::other_methods, problem, options.method.name() + " ");
  const Speed speed = options.speed.of(problem);
  const IndenterAnswer cells = simulate_indenter(problem, speed.velocity);
  SimulationAnswer answer{speed, indenter::steady_state_of(cells.friction), options.method.name(),
                          problem->source->warnings};
  answer.indenter = cells;
  answer.load = under_load(problem);
  return answer;
}

void simulate_below_indenter(const SimulateOptions& options, const Problem& problem) {
  const SimulationAnswer answer = answer_below_indenter(options, problem);
  if (options.json) return print(record::json_of(answer));
  const indenter::Friction& friction = answer.indenter->friction;
  print_friction(problem, answer.speed,
                 {friction.ratio, friction.error, friction.normal_force, friction.regime},
                 options.digits);
  print_load(answer.load, options.digits);
  print_indenter(*answer.indenter, options.digits);
}

void simulate(const SimulateOptions& options) {
  const Problem problem = options.scene.read();
  if (rules::cells_move(problem)) return simulate_below_indenter(options, problem);
  const simulation::System system = simulation::system_of(problem);
  const SimulationAnswer answer = answer_of(options, problem, system);
  if (options.json)
    print(record::json_of(answer));
  else
    print_simulate_text(answer, problem, system, options.digits);
}

}  // namespace

void add_simulate(CLI::App& program) {
  const auto options = std::make_shared<SimulateOptions>();
  CLI::App* command = program.add_subcommand("simulate", "Simulate stick-slip at one speed");
  options->scene.add_to(*command);
  options->speed.add_to(*command);
  options->method.add_to(*command);
  add_digits(*command, options->digits);
  command->add_flag("--json", options->json, "print one JSON object");
  command->callback([options] { simulate(*options); });
}

}  // namespace vcrit::app
