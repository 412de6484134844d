// What masses in the drive cost the exact method: a body at the end of a chain of equal masses,
// springs and dampers, beside the same body alone, at equal fastest frequency.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <complex>
#include <memory>
#include <vector>

#include "base/constants.hpp"
#include "harness/commands.hpp"
#include "harness/text_table.hpp"
#include "harness/timing.hpp"
#include "simulation/steady/curve.hpp"
#include "simulation/steady/exact.hpp"
#include "simulation/system/system.hpp"
#include "stiffness/dynamic_matrix.hpp"

namespace vcrit::bench {

namespace {

// Units: the oscillation has omega = 1, the contact a stiffness of 1, the mean normal force is 1.
constexpr double damping_ratio = 0.02;  // of each spring, at the fastest frequency
constexpr double mu0 = 0.3, force_amplitude = 0.7;
constexpr int speeds = 50;

struct Chain {
  simulation::System system;
  double v_star = 0;
};

/// As many masses as that in a row, the first of them the body, the last held by the far end.
DriveStructure chain_of(int masses, double mass, double spring, double damper) {
  const auto size = static_cast<std::size_t>(masses);
  DriveStructure chain;
  chain.mass.assign(size, mass);
  chain.stiffness = Dense<long double>(size, size);
  chain.damping = Dense<long double>(size, size);
  for (std::size_t i = 0; i < size; ++i) {
    const double neighbours = i == 0 ? 1 : 2;
    chain.stiffness(i, i) = neighbours * spring;
    chain.damping(i, i) = neighbours * damper;
    if (i + 1 == size) continue;
    chain.stiffness(i, i + 1) = chain.stiffness(i + 1, i) = -spring;
    chain.damping(i, i + 1) = chain.damping(i + 1, i) = -damper;
  }
  chain.port.assign(size, 0);
  chain.port[0] = 1;
  chain.together.assign(size, 1);
  return chain;
}

/// The fastest of a row of equal masses, held at one end, swings at 2 sqrt(k/m) cos(pi/(2 N + 1)).
Chain with(int masses, double fastest) {
  const double mass = 1.0 / masses;
  const double share = 2 * std::cos(pi / (2 * masses + 1));
  const double spring = mass * std::pow(fastest / share, 2);
  const double damper = 2 * damping_ratio * spring / fastest;
  Chain chain;
  simulation::System& system = chain.system;
  system.contact = {1, 0, {}};
  system.omega = 1;
  system.friction = mu0;
  system.mean_normal_force = 1;
  system.normal_force_amplitude = force_amplitude;
  const DriveStructure structure = chain_of(masses, mass, spring, damper);
  const std::complex<long double> receptance = displacements(structure, {0, 1}).front();
  if (masses == 1) {
    system.drive = Relaxation{spring, damper, {}};
    system.mass = mass;
  } else {
    simulation::hold_by(system, structure);
  }
  chain.v_star = mu0 * force_amplitude * static_cast<double>(std::abs(1.0L + receptance));
  return chain;
}

double seconds_of_curve(const Chain& chain, double repeat) {
  std::vector<double> velocities;
  for (int i = 1; i <= speeds; ++i) velocities.push_back(chain.v_star * i / (speeds + 1));
  return settled_time([&] { simulation::friction_curve(chain.system, velocities, [](auto...) {}); },
                      repeat) /
         speeds;
}

// Another drive each time, by a share that changes nothing else: its free motions are found anew.
double seconds_of_new_drive(const Chain& chain, double repeat) {
  simulation::System system = chain.system;
  double share = 1;
  return settled_time(
      [&] {
        share += 1e-9;
        if (system.masses) {
          auto changed = *chain.system.masses;
          for (long double& rate : changed.motion.rates.numbers()) rate *= share;
          system.masses = std::make_shared<simulation::DriveWithMasses>(std::move(changed));
        }
        simulation::steady_state(system, 0.5 * chain.v_star);
      },
      repeat);
}

// Another amplitude each time, as over the rows of a sweep.
double seconds_of_new_amplitude(const Chain& chain, double repeat) {
  simulation::System system = chain.system;
  return settled_time(
      [&] {
        system.normal_force_amplitude *= 1 - 1e-9;
        simulation::steady_state(system, 0.5 * chain.v_star);
      },
      repeat);
}

template <class Seconds>
void print_times(const char* title, const Seconds& seconds_of) {
  const std::vector<int> numbers{1, 2, 3, 5, 8};
  std::vector<TextRow> rows{{"fastest motion"}};
  for (const int masses : numbers) rows[0].push_back(fmt::format("N = {}", masses));
  for (const int masses : numbers)
    if (masses > 1) rows[0].push_back(fmt::format("{} : 1", masses));
  for (const double fastest : {2.5, 5.5, 20.5, 80.5}) {
    std::vector<double> seconds;
    for (const int masses : numbers) seconds.push_back(seconds_of(with(masses, fastest)));
    TextRow row{fmt::format("{} omega", fastest)};
    for (const double each : seconds) row.push_back(fmt::format("{:.3g} us", 1e6 * each));
    for (std::size_t i = 1; i < seconds.size(); ++i)
      row.push_back(fmt::format("{:.1f}", seconds[i] / seconds[0]));
    rows.push_back(row);
  }
  fmt::print("{}\n\n{}\n", title, text_table(rows, TableStyle::text));
}

void run_masses(double repeat) {
  fmt::print("The exact method, a body and a chain of N masses with it\n\n");
  print_times("A curve over 50 speeds up to v*, per speed",
              [&](const Chain& chain) { return seconds_of_curve(chain, repeat); });
  print_times("One steady state alone, v0 = 0.5 v*, another amplitude each time",
              [&](const Chain& chain) { return seconds_of_new_amplitude(chain, repeat); });
  print_times("One steady state alone, v0 = 0.5 v*, another drive each time",
              [&](const Chain& chain) { return seconds_of_new_drive(chain, repeat); });
}

}  // namespace

void add_masses(CLI::App& program, int&) {
  const auto repeat = std::make_shared<double>(0.5);
  CLI::App& command = *program.add_subcommand(
      "masses", "Run time of the exact method by the number of masses in the drive.");
  command.add_option("--repeat", *repeat, "seconds for each time")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command.callback([=] { run_masses(*repeat); });
}

}  // namespace vcrit::bench
