#include "compare/without_formula.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "answers/critical_onset.hpp"
#include "answers/friction.hpp"
#include "compare/friction.hpp"
#include "compare/held_cells.hpp"
#include "compare/held_velocity.hpp"
#include "compare/influences.hpp"
#include "compare/values.hpp"
#include "compare/velocity_comparisons.hpp"
#include "critical/admissibility.hpp"
#include "indenter/half_space.hpp"

namespace vcrit::validation {

namespace {

void trace_friction(SceneReport& report, double speed) {
  const SteadyFriction friction(report.problem);
  std::vector<double> velocities;
  for (const double ratio : curve_ratios()) velocities.push_back(ratio * speed);
  friction.curve(velocities, [&](std::size_t i, const simulation::PassingPoint& point) {
    if (point.state == nullptr) return;
    const simulation::SteadyState& state = *point.state;
    report.curve.push_back({curve_ratios()[i],
                            velocities[i],
                            state.friction_ratio,
                            state.friction_ratio,
                            state.friction_ratio_error,
                            to_text(state.regime),
                            {}});
  });
}

// By docs/physics.md; whatever the contact, the body and its drive.
Comparison compare_rise(const SceneReport& report) {
  Comparison comparison;
  comparison.key = "rise";
  comparison.name = "friction never falls with the speed";
  comparison.reference = "energy of the difference of two motions";
  comparison.measure = Comparison::Measure::absolute;
  comparison.reason = "the errors of both friction ratios";
  for (std::size_t i = 0; i + 1 < report.curve.size(); ++i) {
    const ComparedPoint &slow = report.curve[i], &fast = report.curve[i + 1];
    comparison.found = std::max(comparison.found, slow.from_sliding - fast.from_sliding);
    comparison.tolerance = std::max(comparison.tolerance, slow.error + fast.error);
  }
  return comparison;
}

// How far from v* to either side plain cells are marched at, a share of it. A stick so far below v*
// lasts for 2 sqrt(0.002) rad, some 28 steps.
constexpr double held_share = 1e-3;
constexpr int held_march_steps = 2000;
// A cell touches late or early by half its width: of n cells the body's rate is wrong by 1/2n of
// itself at most. It is at most the sum of v* and of the rate of the indentation, which are far
// more than v* near antiresonance. So many cells for each such sum leave it at half the share.
constexpr double held_cells_a_part = 1000, most_held_cells = 10'000;

Comparison held_march(double speed) {
  Comparison comparison;
  comparison.key = "marched";
  comparison.name = fmt::format("plain cells in steps of time stick at {} v* and slide at {} v*",
                                1 - held_share, 1 + held_share);
  comparison.reference = "maximum over the phase";
  comparison.unit = "m/s";
  comparison.expected = comparison.found = speed;
  comparison.tolerance = held_share;
  comparison.reason = "the speeds that were marched at";
  return comparison;
}

Comparison compare_held_march(const indenter::HalfSpace& half_space, double speed) {
  Comparison comparison = held_march(speed);
  const double indentation = half_space.friction() / half_space.shear_ratio() *
                             half_space.amplitude() * half_space.omega();
  const double cells = held_cells_a_part * (1 + indentation / speed);
  if (cells > most_held_cells)
    return not_run(comparison, "near antiresonance v* is a small difference of large rates");
  const auto sticks = [&](double ratio) {
    return march_held_cells(half_space, ratio * speed, static_cast<int>(cells), held_march_steps)
        .sticks;
  };
  if (!sticks(1 - held_share)) return broken(comparison, "all cells slide below v* already");
  if (sticks(1 + held_share)) return broken(comparison, "a cell still sticks above v*");
  return comparison;
}

// At a speed at which about half of a period is stick.
constexpr double held_speed = 0.3;
// Of the finest of three, each twice as fine.
constexpr int held_friction_cells = 400, held_friction_steps = 4000;

Comparison compare_held_friction(const Problem& problem, const indenter::HalfSpace& half_space,
                                 double speed) {
  const double velocity = held_speed * speed;
  const auto march = [&](int part) {
    return march_held_cells(half_space, velocity, held_friction_cells / part,
                            held_friction_steps / part)
        .ratio;
  };
  const double coarse = march(4), middle = march(2), fine = march(1);
  const simulation::SteadyState state = SteadyFriction(problem).at(velocity);
  Comparison comparison;
  comparison.key = "cells";
  comparison.name = fmt::format("friction at {} v*", held_speed);
  comparison.reference = "plain cells in steps of time";
  comparison.measure = Comparison::Measure::absolute;
  comparison.expected = fine;
  comparison.found = state.friction_ratio;
  comparison.tolerance =
      state.friction_ratio_error + 2 * (std::abs(fine - middle) + std::abs(middle - coarse) / 4);
  comparison.reason = "what cells and steps twice as fine change, twice, and the error stated";
  return comparison;
}

void compare_held_harmonics(SceneReport& report, const indenter::HalfSpace& half_space,
                            const CriticalOnset& onset) {
  try {
    report.comparisons.push_back(compare_held_velocity(half_space, onset));
  } catch (const ModelError& error) {
    Comparison none = held_march(onset.drive_velocity);
    none.key = "harmonics";
    none.name = "v* by the harmonics of the normal force";
    report.comparisons.push_back(not_run(none, error.what()));
  }
}

/// Motions that share nothing with those of the continuum.
void compare_held_cells(SceneReport& report, const indenter::HalfSpace& half_space, double speed) {
  const Comparison none = held_march(speed);
  if (!half_space.holder() || !(half_space.holder()->drive.equilibrium > 0)) {
    report.comparisons.push_back(not_run(none, "plain cells are marched on a drive with a spring"));
    return;
  }
  try {
    report.comparisons.push_back(compare_held_march(half_space, speed));
    report.comparisons.push_back(compare_held_friction(report.problem, half_space, speed));
  } catch (const ModelError& error) {
    report.comparisons.push_back(not_run(none, error.what()));
  }
}

/// Of a reason of the rulebook, for the page.
std::string as_sentence(std::string reason) {
  reason.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(reason.front())));
  return reason + ".";
}

Comparison no_formula_to_compare(const std::string& why) {
  Comparison comparison;
  comparison.key = "formula";
  comparison.name = "formula of v*";
  comparison.reference = "motion";
  comparison.unit = "m/s";
  return not_run(comparison, why);
}

}  // namespace

SceneReport report_without_formula(const Problem& problem, const std::string& why,
                                   const Witnesses& witnesses) {
  SceneReport report(problem);
  report.failure = as_sentence(why);
  report.reasons = inadmissible_reasons(problem);
  report.values = value_lines(problem);
  try {
    const CriticalOnset onset = critical_onset(problem);
    report.effect = effect_of(problem, onset);
    report.influences = influences(problem, report.values);
    const bool finite = onset.drive_velocity > 0 && std::isfinite(onset.drive_velocity);
    if (!report.reasons.empty() || !finite) {
      report.comparisons.push_back(no_formula_to_compare(why));
      return report;
    }
    const indenter::HalfSpace half_space = witnesses.half_space(problem);
    compare_held_harmonics(report, half_space, onset);
    compare_held_cells(report, half_space, onset.drive_velocity);
    trace_friction(report, onset.drive_velocity);
    report.comparisons.push_back(compare_rise(report));
  } catch (const ModelError& error) {
    report.failure = as_sentence(error.what());
  }
  return report;
}

}  // namespace vcrit::validation
