#include "paper/evidence.hpp"

#include <fmt/core.h>

#include <array>
#include <cmath>

#include "base/constants.hpp"
#include "paper/comparing.hpp"
#include "paper/motions.hpp"
#include "paper/references.hpp"
#include "simulation/methods/methods.hpp"
#include "simulation/steady/exact.hpp"
#include "simulation/steady/onset.hpp"

namespace vcrit::validation::paper {

namespace {

using simulation::Method;
using simulation::MethodOptions;

constexpr std::array steps{2000, 4000, 8000};

std::vector<double> by_moreau(const simulation::System& system, double velocity) {
  std::vector<double> frictions;
  for (const int each : steps) {
    MethodOptions options;
    options.steps_per_period = each;
    frictions.push_back(steady_state(Method::moreau, system, velocity, options).friction_ratio);
  }
  return frictions;
}

Witness witness_of(const FrictionValue& row) {
  const simulation::System system = kelvin_contact(row.delta, reference_amplitude);
  const double velocity = row.ratio * kelvin_critical_velocity(row.delta, reference_amplitude);
  MethodOptions options;
  options.tolerance = 1e-12;
  const auto exact = simulation::steady_state(system, velocity);
  const auto adaptive = steady_state(Method::rk8pd, system, velocity, options);
  return {row.delta,
          row.ratio,
          row.friction,
          exact.friction_ratio,
          exact.friction_ratio_error,
          by_moreau(system, velocity),
          adaptive.friction_ratio,
          adaptive.friction_ratio_error,
          reduced_friction(row.delta, reference_amplitude, row.ratio)};
}

Comparison threshold(double delta) {
  const simulation::System system = kelvin_contact(delta, reference_amplitude);
  return comparison({"threshold", fmt::format("critical speed by simulation, δ = {}", delta),
                     "(31): μ₀ ω du_z k_n/k_t", "closed forms in doubles: room for 4000 roundings",
                     Comparison::Measure::relative},
                    {kelvin_critical_velocity(delta, reference_amplitude),
                     simulation::sliding_threshold(system).contact_velocity, 1e-12, ""});
}

Comparison last_stick(double delta) {
  const simulation::System system = kelvin_contact(delta, reference_amplitude);
  return comparison(
      {"last_stick", fmt::format("highest speed with stick by simulation, δ = {}", delta),
       "(31): μ₀ ω du_z k_n/k_t",
       "sticks of 10⁻⁶ of a period are found, and v* − v₀ is their "
       "length squared",
       Comparison::Measure::relative},
      {kelvin_critical_velocity(delta, reference_amplitude),
       simulation::stick_onset(system).contact_velocity, 1e-11, ""});
}

/// Isotropic, c_n/k_n = c_t/k_t; the numbers of the scene typed into (29) once more.
Comparison driven_threshold() {
  const Problem problem = parse_problem(
      "[contact]\nnormal = \"kelvin(kn, cn)\"\ntangential = \"kelvin(kt, ct)\"\n"
      "[drive]\nnetwork = \"kd\"\n[body]\nmass = 0.4\n[oscillation]\nangular_frequency = 1.3\n"
      "amplitude = 0.1\nindentation = 1.0\n[friction]\ncoefficient = 0.3\n[elements]\n"
      "kn = 3.0\ncn = 0.6\nkt = 2.0\nct = 0.4\nkd = 1.5\n",
      "paper");
  const double reach = 1.5 - 0.4 * 1.3 * 1.3;
  const double expected =
      0.3 * 1.3 * 0.1 / std::abs(reach) * std::hypot(1.3 * 0.6, 3.0 / 2.0 * (2.0 + reach));
  const auto found = simulation::sliding_threshold(simulation::system_of(problem));
  return comparison(
      {"driven_threshold", "critical speed by simulation, elastic drive and body",
       "(29), written by hand",
       "closed forms in doubles: room for 40 000 roundings, and for a body that swings",
       Comparison::Measure::relative},
      {expected, found.contact_velocity, 1e-11, ""});
}

}  // namespace

// Moreau's method knows each of two events to a step h. Friction is stationary in them, so that
// each costs up to a h^2/(2 pi); the steps between, of second order, are given as much as both.
std::vector<Comparison> compare_witness(const Witness& w) {
  const auto what = [&](const char* key, const char* method, const char* reason) {
    return ComparedQuantity{key, fmt::format("{}, δ = {}, v₀/v* = {}", method, w.delta, w.ratio),
                            "25 digits", reason};
  };
  std::vector<Pair> by_steps;
  for (std::size_t i = 0; i < w.moreau.size(); ++i) {
    const double h = two_pi / steps.at(i);
    by_steps.push_back({w.reference, w.moreau[i], 2 * reference_amplitude * h * h / pi,
                        fmt::format("worst with {} steps a period", steps.at(i))});
  }
  return {
      comparison(what("exact", "exact event-driven motion",
                      "its own estimate of its error, and a rounding of each"),
                 {w.reference, w.exact, w.exact_error + friction_rounding, ""}),
      worst(what("moreau", "Moreau time stepping, steps halved twice",
                 "2 a h²/π with steps h: events are known to a step, and friction is stationary in "
                 "them"),
            by_steps),
      comparison(what("adaptive", "adaptive integrator, rk8pd",
                      "three times its own estimate, of an error that scatters, and two roundings"),
                 {w.reference, w.adaptive, 3 * w.adaptive_error + friction_rounding, ""})};
}

Evidence hear_witnesses() {
  Evidence evidence{reference_amplitude, {steps.begin(), steps.end()}, {}, {}};
  for (const FrictionValue& row : friction_references()) {
    if (row.delta == 2 || (row.ratio != 0.1 && row.ratio != 0.5 && row.ratio != 0.99)) continue;
    evidence.rows.push_back(witness_of(row));
    for (Comparison& each : compare_witness(evidence.rows.back()))
      evidence.comparisons.push_back(std::move(each));
  }
  for (const double delta : figure4_deltas) {
    evidence.comparisons.push_back(threshold(delta));
    evidence.comparisons.push_back(last_stick(delta));
  }
  evidence.comparisons.push_back(driven_threshold());
  return evidence;
}

}  // namespace vcrit::validation::paper
