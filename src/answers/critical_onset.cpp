#include "answers/critical_onset.hpp"

#include <cmath>
#include <limits>

#include "base/constants.hpp"
#include "base/free_swings.hpp"
#include "base/interruption.hpp"
#include "critical/admissibility.hpp"
#include "critical/certified.hpp"
#include "critical/critical_velocity.hpp"
#include "critical/log_derivative.hpp"
#include "indenter/friction.hpp"
#include "network/law.hpp"
#include "network/masses.hpp"
#include "rules/rulebook.hpp"
#include "scene/changing.hpp"
#include "simulation/steady/onset.hpp"
#include "stiffness/dynamic_stiffness.hpp"

namespace vcrit {

namespace {

bool holds_formula(const Scene& scene) {
  return bool{rules::answer(rules::Question::formula, scene)};
}

// Harmonics above this are not looked for below a drive with masses: there the border of sliding is
// within 1e-4 of v*.
constexpr int highest_harmonic = 100;

// In units of what one rounding of every element and step changes: K_d and m (n omega)^2 are equal.
constexpr double equal_in_roundings = 16;

// So close to a frequency at which a mass keeps its end still that K_d has no digits, it is
// infinite.
constexpr double ill_conditioned = 1e8;

// What the elements have of stiffness, damping and inertia, all of it.
struct DriveParts {
  DriveParts(const Network& drive, const Values& values) {
    for_each_element(drive, [&](const Element& element) {
      for_each_number(element, [&](const Symbol& symbol, NumberRole role) {
        const double number = values.at(symbol);
        if (role == NumberRole::stiffness) stiffness += number;
        if (role == NumberRole::damping) damping += number;
        if (role == NumberRole::mass) mass += number;
      });
    });
  }
  double at(double frequency) const {
    return stiffness + damping * frequency + mass * frequency * frequency;
  }

  double stiffness = 0, damping = 0, mass = 0;
};

// The harmonics at which a body, of whatever mass, and the masses of its drive swing freely: K_d =
// m (n omega)^2. A damper that moves with them leaves a loss stiffness, which is no rounding.
std::vector<int> free_harmonics_of_masses(const Network& drive, const Values& values, double mass,
                                          double omega) {
  const Reduction reduction = reduce(drive);
  const DriveParts parts(drive, values);
  std::vector<int> found;
  for (int n = 2; n <= highest_harmonic; ++n) {
    hear_interruption();
    const double frequency = n * omega, inertia = mass * frequency * frequency;
    const double off = std::abs(dynamic_stiffness(reduction, values, frequency) - inertia);
    const double most_uncertain = ill_conditioned * (parts.at(frequency) + inertia);
    if (!(off <= equal_in_roundings * epsilon * most_uncertain)) continue;
    const double uncertain = sensitivity(reduction, values, frequency) + inertia;
    if (uncertain < most_uncertain && off <= equal_in_roundings * epsilon * uncertain)
      found.push_back(n);
  }
  return found;
}

CriticalOnset by_formula(const Scene& scene) {
  const auto [value, bound, reason] = certified_critical_velocity(scene);
  CriticalOnset onset{
      CriticalOnset::By::formula, value, value + creep_velocity(scene), bound, reason, value};
  onset.free_harmonics = free_harmonics(scene);
  if (std::isfinite(value)) onset.sliding_from *= least_maximum(onset.free_harmonics).upper;
  return onset;
}

simulation::Onset sliding_threshold(const Scene& scene) {
  if (scene.indenter) return indenter::sliding_threshold(indenter::HalfSpace(scene));
  return simulation::sliding_threshold(simulation::system_of(scene));
}

CriticalOnset by_simulation(const Scene& scene) {
  const simulation::Onset onset = sliding_threshold(scene);
  CriticalOnset result{CriticalOnset::By::simulation,
                       onset.contact_velocity,
                       onset.drive_velocity,
                       std::numeric_limits<double>::quiet_NaN(),
                       onset.why_infinite,
                       onset.contact_velocity};
  if (std::isfinite(onset.contact_velocity))
    result.relative_error = onset.uncertainty / onset.contact_velocity;
  return result;
}

// Steps of ln p. Differences of fourth order err by their fourth power, 1e-12, and the 1e-13 to
// which v* is simulated by 1e-10.
constexpr double log_step = 1e-3;

}  // namespace

std::vector<int> free_harmonics(const Scene& scene) {
  if (!scene.drive || !rules::answer(rules::Question::all_frequencies, scene)) return {};
  const Values values = values_of(scene);
  const double mass = scene.mass ? values.at(scene.mass->symbol) : 0;
  const double omega = values.at(scene.angular_frequency.symbol);
  if (has_masses(*scene.drive)) return free_harmonics_of_masses(*scene.drive, values, mass, omega);
  const int n = simulation::free_harmonic(relaxation_form(*scene.drive, values), mass, omega);
  return n > 1 ? std::vector{n} : std::vector<int>{};
}

CriticalOnset critical_onset(const Scene& scene) {
  return holds_formula(scene) ? by_formula(scene) : by_simulation(scene);
}

CertifiedVelocity certified_onset(const Scene& scene) {
  if (holds_formula(scene)) return certified_critical_velocity(scene);
  const CriticalOnset onset = by_simulation(scene);
  return {onset.contact_velocity, onset.relative_error_bound, onset.reason};
}

double quick_onset(Scene scene, double omega) {
  scene.angular_frequency.value = omega;
  return holds_formula(scene) ? critical_velocity(scene) : by_simulation(scene).contact_velocity;
}

double onset_log_derivative(const Scene& scene, const Symbol& symbol) {
  if (holds_formula(scene)) return log_derivative(scene, symbol);
  ChangingScene changing(scene, {to_text(as_called(scene, symbol))});
  const double value = changing.targets().front().value->value();
  const auto log_velocity = [&](double steps) {
    const double changed = value * std::exp(steps * log_step);
    return std::log(critical_onset(changing.at({&changed, 1})).contact_velocity);
  };
  const double near = log_velocity(1) - log_velocity(-1), far = log_velocity(2) - log_velocity(-2);
  const double change = (8 * near - far) / (12 * log_step);
  if (!std::isfinite(change))
    throw ModelError("v* is 0 or infinite, so that it has no relative sensitivity");
  return change;
}

}  // namespace vcrit
