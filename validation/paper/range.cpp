#include "paper/range.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/constants.hpp"
#include "compare/friction.hpp"
#include "critical/critical_velocity.hpp"
#include "paper/comparing.hpp"
#include "paper/motions.hpp"
#include "paper/references.hpp"
#include "paper/scenes.hpp"
#include "simulation/steady/curve.hpp"
#include "simulation/steady/exact.hpp"
#include "simulation/steady/onset.hpp"
#include "stiffness/dynamic_stiffness.hpp"

namespace vcrit::validation::paper {

namespace {

using simulation::System;

/// The lowest speed of continuous sliding by simulation against (24) in doubles.
Comparison rheologies() {
  std::vector<Pair> pairs;
  for (const char* contact : contacts)
    for (const char* tangential : tangentials)
      for (const char* drive : drives) {
        const Problem problem = driven_problem(contact, tangential, drive, true);
        const double expected = critical_velocity(problem);
        const double found =
            simulation::sliding_threshold(simulation::system_of(problem)).contact_velocity;
        pairs.push_back({1, found / expected, 1e-11,
                         fmt::format("worst with {}, {}, {}", contact, tangential,
                                     *drive == '\0' ? "a rigid drive" : drive)});
      }
  return worst({"rheologies",
                fmt::format("lowest speed of continuous sliding, {} contacts and drives, over (24)",
                            pairs.size()),
                "Eq. (24) in doubles",
                "closed forms in doubles: room for 40 000 roundings, and for a body that swings"},
               pairs);
}

/// An elastic contact whose body swings freely at the n-th harmonic.
Comparison free_swing(int n) {
  System system = kelvin_contact(0, reference_amplitude);
  system.drive = Relaxation{3.0 * n * n, 0, {}};
  system.mass = 3;
  // (24): mu0 F_n amplitude times the receptance 1/k_t + 1/(k_d - m omega^2).
  const double by_24 = reference_amplitude * (1 + 1 / (3.0 * n * n - 3));
  return comparison(
      {"free_swing", fmt::format("lowest speed of sliding over v*, drive that swings at {} ω", n),
       "cos(π/(2n))", "closed forms in doubles: room for 4000 roundings",
       Comparison::Measure::relative},
      {std::cos(pi / (2 * n)), simulation::sliding_threshold(system).contact_velocity / by_24,
       1e-12, ""});
}

/// From v* to ten times it there is full friction.
Comparison above() {
  std::vector<Pair> pairs;
  for (const double delta : figure4_deltas)
    for (const double ratio : {1 + 1e-6, 1.01, 1.5, 10.0}) {
      const auto motion = full_motion(delta, reference_amplitude, ratio);
      pairs.push_back({1, motion.friction_ratio, motion.friction_ratio_error + friction_rounding,
                       fmt::format("worst at δ = {}, v₀/v* = {}", delta, ratio)});
    }
  return worst({"above", "friction ratio above v*", "1, full friction",
                "the simulator’s own estimate of its error, and a rounding"},
               pairs);
}

/// Just below there is less.
Comparison below() {
  std::vector<Pair> pairs;
  for (const double delta : figure4_deltas)
    for (const double ratio : {0.9, 0.99, 0.999}) {
      const auto motion = full_motion(delta, reference_amplitude, ratio);
      const double taken = 1 - motion.friction_ratio - motion.friction_ratio_error;
      pairs.push_back({0, std::min(0.0, taken - friction_rounding), 0,
                       fmt::format("worst at δ = {}, v₀/v* = {}", delta, ratio)});
    }
  return worst({"below", "reduction up to 0.999 v*, less its error", "never 0 or less",
                "beyond the simulator’s own estimate of its error"},
               pairs);
}

/// Steady friction from v*/20 to v*, with F_n = mean (1 + 0.8 cos).
std::vector<simulation::SteadyState> rising_speeds(System system) {
  const auto amplitude = std::abs(system.normal_force_amplitude);
  system.normal_force_amplitude *= 0.8 * system.mean_normal_force / amplitude;
  const double threshold = simulation::sliding_threshold(system).drive_velocity;
  std::vector<simulation::SteadyState> states;
  for (int i = 1; i <= 20; ++i) states.push_back(steady_state(system, i / 20.0 * threshold));
  return states;
}

/// How far friction falls from one speed to the next, and how far it bends upwards.
void add_course(const System& system, const std::string& where, std::vector<Pair>& falls,
                std::vector<Pair>& bends) {
  const auto states = rising_speeds(system);
  const auto friction = [&](std::size_t i) { return states[i].friction_ratio; };
  const auto error = [&](std::size_t i) {
    return states[i].friction_ratio_error + friction_rounding;
  };
  for (std::size_t i = 1; i < states.size(); ++i)
    falls.push_back(
        {0, std::min(0.0, friction(i) - friction(i - 1)), error(i) + error(i - 1), where});
  for (std::size_t i = 2; i < states.size(); ++i)
    bends.push_back({0, std::max(0.0, friction(i) - 2 * friction(i - 1) + friction(i - 2)),
                     error(i) + 2 * error(i - 1) + error(i - 2), where});
}

/// Of all contacts and drives without a body that carry a load at rest.
void compare_courses(PaperPart& part) {
  std::vector<Pair> falls, bends;
  for (const char* contact : contacts)
    for (const char* tangential : {"tangential_ratio = 0.7", "tangential = \"zener(k2, k1, c2)\""})
      for (const char* drive : {"", "k3", "kelvin(k3, c3)", "zener(k3, k4, c3)"})
        add_course(simulation::system_of(driven_problem(contact, tangential, drive, false)),
                   fmt::format("worst with {} under {}", contact,
                               *drive == '\0' ? "a rigid drive" : drive),
                   falls, bends);
  const char* reason = "the simulator’s own estimates for the speeds";
  part.comparisons.push_back(worst(
      {"rises", "most that friction falls as the speed rises, no body", "never falls", reason},
      falls));
  part.comparisons.push_back(worst(
      {"concave", "most that friction bends upwards over speed, no body", "never does", reason},
      bends));
}

/// With a body friction may be below the line from 0 to v*.
Comparison below_diagonal() {
  System system = kelvin_contact(0, reference_amplitude);
  system.contact.equilibrium = 3;
  system.drive = Relaxation{0.5, 0.02, {}};
  system.mass = 1.4;
  const double threshold = simulation::sliding_threshold(system).drive_velocity;
  const auto motion = steady_state(system, 0.8 * threshold);
  return comparison(
      {"below_diagonal", "friction ratio at 0.8 v*, a body of mass 1.4 on a weakly damped drive",
       "16 digits, shooting with 40", "the simulator’s own estimate of its error, and a rounding"},
      {0.55834456565932167, motion.friction_ratio, motion.friction_ratio_error + friction_rounding,
       ""});
}

/// |K_n(i omega)| >= K_n(0): the force reaches 0 before the body lifts off.
Comparison force_before_height() {
  std::vector<Pair> pairs;
  for (const char* contact : contacts) {
    const Problem problem = driven_problem(contact, "tangential_ratio = 0.7", "", false);
    const Values& values = problem.values();
    const double at_rest = simulation::system_of(problem).mean_normal_force;  // under u_z0 = 1
    for (int i = -24; i <= 24; ++i) {
      const double omega = std::pow(10, i / 8.0);
      const double over =
          std::abs(dynamic_stiffness(problem->normal.reduction(), values, omega)) / at_rest;
      pairs.push_back({0, std::min(0.0, over - 1), 2e-14, fmt::format("worst with {}", contact)});
    }
  }
  return worst({"force_before_height", "most that |K_n(iω)| is below K_n(0), relative",
                "never below", "both without subtractions: a hundred roundings"},
               pairs);
}

}  // namespace

PaperPart explore_range() {
  PaperPart part;
  part.comparisons.push_back(rheologies());
  for (int n = 2; n <= 5; ++n) part.comparisons.push_back(free_swing(n));
  part.comparisons.push_back(above());
  part.comparisons.push_back(below());
  compare_courses(part);
  part.comparisons.push_back(below_diagonal());
  part.comparisons.push_back(force_before_height());
  return part;
}

}  // namespace vcrit::validation::paper
