#include "compare/separation.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "analysis/separation.hpp"
#include "answers/ringing.hpp"
#include "base/constants.hpp"
#include "base/rounded.hpp"
#include "compare/formulas.hpp"
#include "compare/velocity_comparisons.hpp"
#include "critical/admissibility.hpp"
#include "critical/critical_velocity.hpp"
#include "normal/mount.hpp"
#include "problem/variants.hpp"
#include "rules/rulebook.hpp"
#include "simulation/steady/curve.hpp"
#include "simulation/steady/energy.hpp"
#include "simulation/steady/exact.hpp"
#include "simulation/steady/normal_force.hpp"

namespace vcrit::validation {

namespace {

using simulation::Motion;
using simulation::System;

// Of the border of separation: closed, at it, and far beyond. More could not be told apart, as from
// three times the border on the curves lie close together.
constexpr double border_shares[] = {0.5, 1, 10};

std::vector<double> separation_ratios() {
  std::vector<double> ratios{0.005, 0.01, 0.02, 0.03};
  for (int i = 2; i <= 40; ++i) ratios.push_back(i / 40.0);
  for (const double ratio : {1.05, 1.1, 1.2}) ratios.push_back(ratio);
  return ratios;
}

std::vector<double> even(double from, double to, int count) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(from + (to - from) * (i + 0.5) / count);
  return values;
}

Problem at_amplitude(const Problem& problem, double amplitude) {
  return problem.with({{problem->amplitude.symbol, amplitude}});
}

std::vector<double> friction_over(const System& system, const std::vector<double>& velocities) {
  std::vector<double> friction;
  for (const auto& point : simulation::friction_curve(system, velocities))
    friction.push_back(point.state ? point.state->friction_ratio : no_friction);
  return friction;
}

// Speeds over v* by Eq. 24, of the drive: a path that creeps is left behind by it.
std::vector<double> speeds_at(const std::vector<double>& ratios, double speed) {
  std::vector<double> result;
  for (const double ratio : ratios) result.push_back(ratio * speed);
  return result;
}

FrictionCurve separation_curve(const Problem& problem) {
  FrictionCurve curve;
  curve.ratios = separation_ratios();
  curve.friction = friction_over(simulation::system_of(problem),
                                 speeds_at(curve.ratios, unit_of_speed(problem)));
  return curve;
}

// Within this share of the border two amplitudes are drawn as one.
constexpr double same_amplitude = 0.05;

std::vector<FrictionCurve> curves_of(const Problem& problem, double border) {
  const double indentation = rules::Facts(problem).indentation();
  const double own = problem->amplitude.value.value() / (border * indentation);
  std::vector<double> shares(std::begin(border_shares), std::end(border_shares));
  std::erase_if(shares, [&](double share) { return std::abs(share / own - 1) < same_amplitude; });
  shares.push_back(own);
  std::sort(shares.begin(), shares.end());
  std::vector<FrictionCurve> curves;
  for (const double share : shares) {
    curves.push_back(separation_curve(
        share == own ? problem : at_amplitude(problem, share * border * indentation)));
    curves.back().own = share == own;
    const char* remark = share == own ? ", this scene"
                         : share < 1  ? ", closed"
                         : share == 1 ? ", opens"
                                      : "";
    curves.back().name = rounded(share * border * indentation, "m", 3) + remark;
  }
  return curves;
}

StateMap separation_map(const System& system, double speed) {
  StateMap map{even(0, 1.2, 48), even(0, two_pi, 180), {}};
  for (const double ratio : map.rows) {
    std::vector<std::optional<Motion>> row(map.phases.size());
    try {
      row = motions_in(simulation::steady_state(system, ratio * speed), map.phases);
    } catch (const ModelError&) {
      // No steady state was found: the row stays empty.
    }
    map.motions.insert(map.motions.end(), row.begin(), row.end());
  }
  return map;
}

// So slow that the contact sticks from where it closes to where it opens: its force is
// less than that of the glassy network for the way of one period, unless the body rings meanwhile.
std::optional<Comparison> separation_static_limit(const System& system, double speed) {
  constexpr double most_ringing = 1e3;  // at 1e-9 of v* the tolerance stays below some 1e-5
  const double rings = ringing(system);
  if (!(rings <= most_ringing)) return std::nullopt;
  Comparison comparison = by_difference("static_limit", "friction at rest, v0 -> 0",
                                        "0: whenever the contact closes, the contact begins anew");
  const double velocity = 1e-9 * speed;
  double glassy = system.contact.equilibrium;
  for (const MaxwellBranch& branch : system.contact.branches) glassy += branch.stiffness;
  const double force = (glassy * two_pi / system.omega + system.contact.damper) * velocity;
  const simulation::SteadyState state = simulation::steady_state(system, velocity);
  comparison.found = state.friction_ratio;
  comparison.tolerance = rings * force / (system.friction * simulation::mean_normal_force(system)) +
                         state.friction_ratio_error;
  comparison.reason =
      "at 10⁻⁹ of v*, the stiffest that the network answers with over one period, times what the "
      "stuck body swings beyond it";
  return comparison;
}

// At 2 % of the border and at half of that: friction falls short of mu0 in proportion, as nothing
// slips backward.
std::optional<Comparison> separation_small_amplitude(const Problem& problem, double border) {
  const auto shortfall = [&](double share) -> std::optional<simulation::SteadyState> {
    const Problem there =
        at_amplitude(problem, share * border * rules::Facts(problem).indentation());
    auto state = simulation::steady_state(simulation::system_of(there),
                                          0.5 * unit_of_speed(there) + creep_velocity(there));
    if (state.regime != simulation::Regime::stick_slip) return std::nullopt;
    return state;
  };
  const auto twice = shortfall(0.02), once = shortfall(0.01);
  if (!twice || !once) return std::nullopt;
  Comparison comparison =
      by_difference("small_amplitude", "1 − friction ratio at 1 % of the border, at half of v*",
                    "half of that at 2 %");
  comparison.measure = Comparison::Measure::relative;
  comparison.expected = (1 - twice->friction_ratio) / 2;
  comparison.found = 1 - once->friction_ratio;
  comparison.tolerance =
      (twice->friction_ratio_error + 2 * once->friction_ratio_error + 4e-16) / comparison.found;
  comparison.reason = "the errors of both, over what is left of them";
  return comparison;
}

// So slow an oscillation that every network is as at rest.
std::optional<Comparison> separation_quasi_static(const System& system) {
  const auto& form = system.opening->network;
  if (!(system.contact.equilibrium > 0) || system.drive || system.masses) return std::nullopt;
  System slow = system, elastic = system;
  const double slowest = std::max(slowest_relaxation(form), slowest_relaxation(system.contact));
  if (slowest == 0) return std::nullopt;
  constexpr double slowness = 1e-6;
  slow.omega = elastic.omega = slowness / slowest;
  elastic.contact = {system.contact.equilibrium, 0, {}};
  elastic.opening->network = {form.equilibrium, 0, {}};
  const double speed = system.friction * elastic.omega * elastic.opening->amplitude *
                       form.equilibrium / system.contact.equilibrium;
  Comparison comparison = by_difference(
      "quasi_static", "friction at a frequency far below all relaxation, at half of v*",
      "elastic contact of the stiffness at rest");
  comparison.expected = simulation::steady_state(elastic, 0.5 * speed).friction_ratio;
  comparison.found = simulation::steady_state(slow, 0.5 * speed).friction_ratio;
  comparison.tolerance = 10 * slowness;
  comparison.reason =
      "forces, and times of opening, change by some ω times the slowest relaxation, 10⁻⁶";
  return comparison;
}

std::optional<Comparison> energy(const System& system, double velocity) {
  const auto found = simulation::energy_balance(system, velocity);
  if (!found) return std::nullopt;
  const simulation::EnergyBalance& balance = *found;
  Comparison comparison = by_difference("energy", "heat of friction and dampers over a cycle",
                                        "work of drive and oscillation");
  comparison.unit = "J";
  comparison.expected = balance.drive;
  comparison.found = balance.friction + balance.dampers;
  comparison.tolerance = balance.error;
  comparison.reason = "the simulator's own estimate";
  return comparison;
}

void compare_separation(SceneReport& report, const System& system, double speed) {
  const auto add = [&](std::optional<Comparison> comparison) {
    if (comparison) report.comparisons.push_back(std::move(*comparison));
  };
  add(energy(system, 0.5 * speed));
  if (report.separation->border > 0 && rules::Facts(report.problem).indentation() > 0)
    add(separation_small_amplitude(report.problem, report.separation->border));
  if (!system.opening) return;
  add(separation_static_limit(system, speed));
  add(separation_quasi_static(system));
}

}  // namespace

Comparison by_difference(const char* key, const char* name, const char* reference) {
  Comparison comparison;
  comparison.key = key;
  comparison.name = name;
  comparison.reference = reference;
  comparison.measure = Comparison::Measure::absolute;
  return comparison;
}

double slowest_relaxation(const Relaxation& solid) {
  double slowest = solid.damper / solid.equilibrium;
  for (const MaxwellBranch& branch : solid.branches)
    slowest = std::max(slowest, branch.time * (1 + branch.stiffness / solid.equilibrium));
  return slowest;
}

double unit_of_speed(const Problem& problem) {
  if (const double velocity = critical_velocity(problem); is_speed(velocity)) return velocity;
  return critical_velocity(with_rigid_drive(problem));
}

double opening_border(const Problem& problem) {
  const Relaxation normal = relaxation_form(problem->normal.network(), problem.values());
  const double omega = problem->angular_frequency.value.value();
  return normal.equilibrium /
         (std::abs(dynamic_stiffness(normal, omega)) * mount_factor(problem, omega));
}

std::vector<std::optional<Motion>> motions_in(const simulation::SteadyState& state,
                                              const std::vector<double>& phases) {
  const auto& events = state.events;
  const Motion resting = state.regime == simulation::Regime::stick ? Motion::stick : Motion::slip;
  std::vector<std::optional<Motion>> motions;
  for (const double phase : phases) {
    Motion now = events.empty() ? resting : events.back().to;
    for (const simulation::Event& event : events)
      if (event.phase <= phase) now = event.to;
    motions.emplace_back(now);
  }
  return motions;
}

void examine_separation(SceneReport& report, const symbolic::Derivation& derivation,
                        const System& system, const CriticalOnset& onset) {
  const Problem& problem = report.problem;
  Separation& separation = report.separation.emplace();
  separation.opens = system.opening.has_value();
  separation.closed_form = onset.by == CriticalOnset::By::formula;
  separation.critical_velocity = onset.contact_velocity;
  separation.drive_velocity = onset.drive_velocity;
  separation.border = opening_border(problem);
  separation.derivation = equations_of(symbolic::separation_lines(derivation));
  const double speed = unit_of_speed(problem);
  if (separation.border > 0 && rules::Facts(problem).indentation() > 0)
    separation.curves = curves_of(problem, separation.border);
  separation.map = separation_map(system, speed);
  compare_separation(report, system, speed);
}

}  // namespace vcrit::validation
