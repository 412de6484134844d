#include "compare/indented.hpp"

#include <fmt/core.h>
#include <gsl/gsl_integration.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "answers/critical_onset.hpp"
#include "base/constants.hpp"
#include "compare/border.hpp"
#include "compare/separation.hpp"
#include "compare/velocity_comparisons.hpp"
#include "critical/conditioning.hpp"
#include "critical/critical_velocity.hpp"
#include "indenter/friction.hpp"
#include "normal/mean_indentation.hpp"
#include "problem/variants.hpp"

namespace vcrit::validation {

namespace {

using indenter::Friction;
using indenter::HalfSpace;

// For figures that are compared.
constexpr double compared_error = 1e-11;

// Relative, of the force at rest.
constexpr double quadrature = 1e-10;

const std::vector<double>& indenter_ratios() {
  static const std::vector<double> ratios = [] {
    std::vector<double> all{0.005, 0.02};
    for (int i = 1; i <= 20; ++i) all.push_back(i / 20.0);
    all.push_back(1.1);
    return all;
  }();
  return ratios;
}

FrictionCurve indenter_curve(const Problem& problem, std::string name, bool own) {
  FrictionCurve curve{std::move(name), own, indenter_ratios(), {}};
  std::vector<double> velocities;
  for (const double ratio : curve.ratios) velocities.push_back(ratio * critical_velocity(problem));
  for (const auto& point :
       indenter::friction_curve(HalfSpace(problem), velocities, indenter::drawn_tolerance))
    curve.friction.push_back(point.friction ? point.friction->ratio : no_friction);
  return curve;
}

Problem at_share(const Problem& problem, double share) {
  // Under a load the indentation would change with the amplitude.
  const double indentation = simulation::mean_indentation(problem);
  const Problem there = problem->load ? at_depth(problem, indentation) : problem;
  return there.with({{problem->amplitude.symbol, share * indentation}});
}

// Beyond the whole indentation the indenter jumps, which the scene must allow.
std::vector<FrictionCurve> amplitudes_of(const Problem& problem) {
  const double indentation = simulation::mean_indentation(problem);
  const double own = problem->amplitude.value.value() / indentation;
  std::vector<double> shares{0.05, 0.2, 0.5, 0.9};
  if (problem->separation) shares.insert(shares.end(), {1.5, 4});
  std::erase_if(shares, [&](double share) { return std::abs(share / own - 1) < 0.05; });
  shares.push_back(own);
  std::sort(shares.begin(), shares.end());
  std::vector<FrictionCurve> curves;
  for (const double share : shares) {
    const Problem there = share == own ? problem : at_share(problem, share);
    try {
      curves.push_back(
          indenter_curve(there, fmt::format("{:.3g} of the indentation", share), share == own));
    } catch (const ModelError&) {
      // The pressure of a viscoelastic half-space swings more than its indentation: outside (4).
    }
  }
  return curves;
}

std::vector<FrictionCurve> shapes_of(const Problem& problem) {
  using Shape = Indenter::Shape;
  const auto power = [](double exponent) {
    return Indenter{Shape::power, {{{"prefactor"}, 1.0}, {{"exponent"}, exponent}}, {}};
  };
  const std::pair<const char*, Indenter> shapes[] = {
      {"cone, r", power(1)},
      {"parabola, r²", power(2)},
      {"r⁴", power(4)},
      {"flat", Indenter{Shape::flat, {{{"radius"}, 1.0}}, {}}}};
  std::vector<FrictionCurve> curves;
  const Problem here =
      problem->load ? at_depth(problem, simulation::mean_indentation(problem)) : problem;
  for (const auto& [name, shape] : shapes) {
    curves.push_back(indenter_curve(with_indenter(here, shape), name, false));
  }
  curves.push_back(indenter_curve(problem, "this scene", true));
  return curves;
}

StateMap indenter_map(const HalfSpace& half_space, double velocity) {
  constexpr int count = 60, samples = 180;  // cells; 2 degrees each
  StateMap map;
  for (int i = 0; i < samples; ++i) map.phases.push_back(two_pi * (i + 0.5) / samples);
  const auto cells = indenter::cells(half_space, velocity, count, 0);
  for (const indenter::CellMotion& cell : cells) {
    map.rows.push_back(cell.x / half_space.edge());
    const auto row = motions_in(cell.state, map.phases);
    map.motions.insert(map.motions.end(), row.begin(), row.end());
  }
  return map;
}

Comparison indenter_velocity(const SceneReport& report, const HalfSpace& half_space,
                             const Witnesses& witnesses) {
  Comparison comparison = velocity_comparison(
      report, "balance", "harmonic balance, as Eq. 24, of each cell in relaxation form");
  comparison.found = indenter::sliding_threshold(half_space, witnesses.balance).contact_velocity;
  comparison.tolerance = motion_tolerance(report.condition);
  comparison.reason = "the fastest of all cells, in doubles";
  return comparison;
}

Border border_of_cells(const SceneReport& report, const CriticalOnset& onset) {
  if (onset.by == CriticalOnset::By::formula)
    return {report.critical_velocity, report.critical_velocity, report.condition,
            formula_reference};
  return simulated_border(onset);
}

Comparison compare_last_cell(const Border& border, const indenter::LastStick& last) {
  Comparison comparison = compare_last_stick(border, last.onset);
  if (last.answered < last.asked)
    comparison.detail =
        fmt::format("{} of the {} cells that were asked have no steady state: of the others",
                    last.asked - last.answered, last.asked);
  return comparison;
}

void compare_cells(SceneReport& report, const HalfSpace& half_space, const CriticalOnset& onset,
                   const Witnesses& witnesses) {
  const Border border = border_of_cells(report, onset);
  if (!is_speed(border.contact_velocity)) {
    report.comparisons.push_back(compare_stick_without_end(border, half_space.cell(0)));
    report.comparisons.push_back(compare_march_without_end(border, half_space.cell(0)));
    return;
  }
  const std::vector<Comparison> velocities = report.comparisons;
  try {
    const indenter::LastStick last = indenter::last_stick(half_space);
    report.comparisons.push_back(compare_last_cell(border, last));
    if (onset.by == CriticalOnset::By::formula)
      if (const auto farthest = compare_evaluators(velocities, last.onset, border.condition))
        report.comparisons.push_back(*farthest);
    report.comparisons.push_back(witnesses.march(border, half_space.cell(last.x)));
  } catch (const ModelError& error) {
    report.comparisons.push_back(not_run(compare_last_stick(border, {}), error.what()));
    report.comparisons.push_back(witnesses.march(border, half_space.cell(0)));
  }
}

Comparison starts(const Friction& friction) {
  Comparison comparison =
      by_difference("starts", "friction of each cell, started from rest", "started from sliding");
  comparison.found = friction.disagreement;
  comparison.tolerance = 2e-9;
  comparison.reason = "each steady value is promised to 10⁻⁹, and both may be off";
  comparison.detail = fmt::format("worst of {} cells, at half of v*", friction.cells);
  return comparison;
}

// Each cell then carries the least force of the period, that under the depth u_z0 - s, where s is
// the amplitude grown by |E(i omega)|/E(0); the contact's own answer to the way of one period is on
// top.
Comparison indenter_static_limit(const SceneReport& report, const HalfSpace& half_space,
                                 double speed) {
  Comparison comparison = by_difference("static_limit", "friction at rest, v0 → 0",
                                        "least over mean normal force of the cells");
  const double velocity = 1e-9 * speed;
  const Friction friction = indenter::friction(half_space, velocity, compared_error);
  const double swing = half_space.amplitude() / opening_border(report.problem);
  const simulation::System centre = half_space.cell(0);
  double glassy = centre.contact.equilibrium;
  for (const MaxwellBranch& branch : centre.contact.branches) glassy += branch.stiffness;
  const double answer =
      (glassy * two_pi / centre.omega + centre.contact.damper) * velocity * 2 * half_space.edge();
  const double mu0 = report.problem->coefficient.value.value();
  comparison.expected =
      static_force(half_space, half_space.indentation() - swing) / friction.normal_force;
  comparison.found = friction.ratio;
  comparison.tolerance = answer / (mu0 * friction.normal_force) + friction.error + quadrature;
  comparison.reason = "at 10⁻⁹ of v*, the stiffest answer over one period, and the stated error";
  return comparison;
}

Friction at_half(const Problem& problem) {
  return indenter::friction(HalfSpace(problem), 0.5 * critical_velocity(problem), compared_error);
}

// Cells that stay closed fall short of mu0 in proportion to the amplitude; the rim that opens is as
// wide as the amplitude and carries as little force.
std::optional<Comparison> indenter_small_amplitude(const Problem& problem) {
  constexpr double share = 1e-3;
  const Friction once = at_half(at_share(problem, share)),
                 twice = at_half(at_share(problem, 2 * share));
  if (once.regime == simulation::Regime::stick_slip_backslip_separated) return std::nullopt;
  Comparison comparison =
      by_difference("small_amplitude", "1 − friction ratio at Δu_z = 0.001 u_z0, at half of v*",
                    "half of that at 0.002 u_z0");
  comparison.measure = Comparison::Measure::relative;
  comparison.expected = (1 - twice.ratio) / 2;
  comparison.found = 1 - once.ratio;
  comparison.tolerance = 3 * share;
  comparison.reason =
      "the rim that opens, at both amplitudes: its share of the width, 10⁻³ and twice that";
  return comparison;
}

// So slow an oscillation that the half-space is as at rest.
std::optional<Comparison> indenter_quasi_static(const Problem& problem) {
  constexpr double slowness = 1e-6;
  const Relaxation modulus = relaxation_form(problem->normal.network(), problem.values());
  const double slowest = slowest_relaxation(modulus);
  if (slowest == 0) return std::nullopt;
  const Problem slow = problem.with({{problem->angular_frequency.symbol, slowness / slowest}});
  const Problem elastic = with_normal_spring(slow, {"E"}, modulus.equilibrium);
  Comparison comparison = by_difference(
      "quasi_static", "friction at a frequency far below all relaxation, at half of v*",
      "elastic half-space of the modulus at rest");
  comparison.expected = at_half(elastic).ratio;
  comparison.found = at_half(slow).ratio;
  comparison.tolerance = 10 * slowness;
  comparison.reason =
      "forces, and times of opening, change by some ω times the slowest relaxation, 10⁻⁶";
  return comparison;
}

}  // namespace

double static_force(const HalfSpace& half_space, double depth) {
  if (!(depth > 0)) return 0;
  struct Data {
    const HalfSpace* half_space;
    double depth;
  } data{&half_space, depth};
  gsl_function function{[](double x, void* given) {
                          const Data& d = *static_cast<const Data*>(given);
                          return std::max(d.depth - d.half_space->gap().at(x), 0.0);
                        },
                        &data};
  const std::unique_ptr<gsl_integration_workspace, void (*)(gsl_integration_workspace*)> workspace(
      gsl_integration_workspace_alloc(1000), gsl_integration_workspace_free);
  double sum = 0, error = 0;
  gsl_integration_qag(&function, 0, half_space.gap().half_width(depth), 0, quadrature, 1000,
                      GSL_INTEG_GAUSS21, workspace.get(), &sum, &error);
  return 2 * half_space.static_modulus() * sum;
}

void examine_indenter(SceneReport& report, const CriticalOnset& onset, const Witnesses& witnesses) {
  const Problem& problem = report.problem;
  const HalfSpace half_space = witnesses.half_space(problem);
  const double speed = critical_velocity(problem);
  Indented& indented = report.indented.emplace();
  indented.closed_form = onset.by == CriticalOnset::By::formula;
  indented.critical_velocity = border_of_cells(report, onset).contact_velocity;
  indented.radius = half_space.radius();
  indented.edge = half_space.edge();
  indented.amplitudes = amplitudes_of(problem);
  indented.shapes = shapes_of(problem);
  indented.map_ratio = 0.5;
  indented.map = indenter_map(half_space, indented.map_ratio * speed);
  const Friction half = indenter::friction(half_space, 0.5 * speed, compared_error);
  indented.normal_force = half.normal_force;
  compare_cells(report, half_space, onset, witnesses);
  if (indented.closed_form)
    report.comparisons.push_back(indenter_velocity(report, half_space, witnesses));
  report.comparisons.push_back(starts(half));
  report.comparisons.push_back(indenter_static_limit(report, half_space, speed));
  for (const auto& comparison : {indenter_small_amplitude(problem), indenter_quasi_static(problem)})
    if (comparison) report.comparisons.push_back(*comparison);
}

}  // namespace vcrit::validation
