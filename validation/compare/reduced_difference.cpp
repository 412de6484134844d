#include "compare/reduced_difference.hpp"

#include <algorithm>
#include <cmath>

#include "simulation/methods/methods.hpp"
#include "simulation/steady/exact.hpp"
#include "simulation/steady/onset.hpp"

namespace vcrit::validation {

namespace {

constexpr double tolerance = 0.01;

}  // namespace

simulation::System kelvin_contact(double delta, double a) {
  simulation::System system;
  system.contact = {1, delta, {}};
  system.omega = 1;
  system.friction = 1;
  system.mean_normal_force = 1;
  system.normal_force_amplitude = a;
  return system;
}

ReducedAndFull reduced_and_full(double delta, double ratio, double a) {
  const simulation::System system = kelvin_contact(delta, a);
  const double velocity = ratio * simulation::sliding_threshold(system).contact_velocity;
  return {steady_state(simulation::Method::reduced, system, velocity).friction_ratio,
          simulation::steady_state(system, velocity).friction_ratio};
}

ReducedTable reduced_table(double a, const std::vector<double>& deltas,
                           const std::vector<double>& ratios) {
  ReducedTable table{a, ratios, deltas, {}};
  for (const double delta : deltas) {
    table.rows.emplace_back();
    for (const double ratio : ratios)
      table.rows.back().push_back(reduced_and_full(delta, ratio, a));
  }
  return table;
}

std::optional<double> usable_from(double delta, double a, double allowed) {
  std::optional<double> least;
  for (int percent = 99; percent > 0; --percent) {
    const double ratio = percent / 100.0;
    if (std::abs(reduced_and_full(delta, ratio, a).difference()) > allowed) break;
    least = ratio;
  }
  return least;
}

std::optional<ReducedModel> reduced_model(const Problem& problem) {
  if (problem->drive_network() != nullptr ||
      !std::holds_alternative<Isotropic>(problem->tangential))
    return std::nullopt;
  const simulation::System system = simulation::system_of(problem);
  if (system.opening) return std::nullopt;
  const Relaxation& contact = system.contact;
  if (!(contact.equilibrium > 0 && contact.damper > 0) || !contact.branches.empty())
    return std::nullopt;
  ReducedModel model;
  model.delta = system.omega * contact.damper / contact.equilibrium;
  model.tolerance = tolerance;
  const double a = std::abs(system.normal_force_amplitude) / system.mean_normal_force;
  model.usable_from = usable_from(model.delta, a, tolerance);
  std::vector<double> deltas{model.delta};
  for (const double delta : {0.03, 0.1, 0.3, 1.0, 3.0, 10.0, 100.0})
    if (std::abs(std::log(delta / model.delta)) > 0.2) deltas.push_back(delta);
  std::sort(deltas.begin(), deltas.end());
  model.table = reduced_table(a, deltas, {0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95});
  return model;
}

}  // namespace vcrit::validation
