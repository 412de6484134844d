#include "answers/critical_onset.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "answers/realised_friction.hpp"
#include "answers/slope.hpp"
#include "base/constants.hpp"
#include "base/free_swings.hpp"
#include "base/interruption.hpp"
#include "critical/admissibility.hpp"
#include "critical/certified.hpp"
#include "critical/critical_velocity.hpp"
#include "critical/log_derivative.hpp"
#include "indenter/friction.hpp"
#include "modes/general_modes.hpp"
#include "network/law.hpp"
#include "network/masses.hpp"
#include "problem/variants.hpp"
#include "problem/variation.hpp"
#include "rules/kinds.hpp"
#include "rules/rulebook.hpp"
#include "simulation/steady/onset.hpp"
#include "stiffness/dynamic_stiffness.hpp"

namespace vcrit {

namespace {

bool holds_formula(const Problem& problem) {
  return bool{rules::answer(rules::Question::formula, problem)};
}

// A drive with masses is searched for free swings up to this harmonic N. However many there are
// above it, they lower the border of sliding by less than 1e-4: under Fejer's measure harmonics
// above N have mean 0, and the oscillation has the mean cos(pi/(N + 2)).
constexpr int highest_harmonic = 221;

// With a condition number above this K_d has no digits left and counts as infinite: a mass of the
// drive keeps its end still.
constexpr double ill_conditioned = 1e8;

// Sums of stiffness, damping and mass over all elements of the drive.
struct DriveParts {
  DriveParts(const Network& drive, const Values& values) {
    for_each_element(drive, [&](const Element& element) {
      for_each_amount(element, [&](const Amount& amount, NumberRole role) {
        const double number = *amount_value(amount, values);
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
std::vector<int> free_harmonics_of_masses(const ReducedNetwork& drive, const Values& values,
                                          double mass, double omega) {
  const Reduction& reduction = drive.reduction();
  const DriveParts parts(drive.network(), values);
  const double nearly_equal = simulation::equal_in_roundings * epsilon;
  std::vector<int> found;
  for (int n = 2; n <= highest_harmonic; ++n) {
    hear_interruption();
    const double frequency = n * omega, inertia = mass * frequency * frequency;
    const double off = std::abs(dynamic_stiffness(reduction, values, frequency) - inertia);
    const double most_uncertain = ill_conditioned * (parts.at(frequency) + inertia);
    if (!(off <= nearly_equal * most_uncertain)) continue;
    const double uncertain = sensitivity(reduction, values, frequency) + inertia;
    if (uncertain < most_uncertain && off <= nearly_equal * uncertain) found.push_back(n);
  }
  return found;
}

CriticalOnset by_formula(const Problem& problem) {
  const auto [value, bound, reason] = certified_critical_velocity(problem);
  CriticalOnset onset{
      CriticalOnset::By::formula, value, value + creep_velocity(problem), bound, reason, value};
  onset.free_harmonics = free_harmonics(problem);
  if (std::isfinite(value)) onset.sliding_from *= sliding_share(onset.free_harmonics);
  return onset;
}

simulation::Onset sliding_threshold(const Problem& problem, simulation::KnownModes* known) {
  if (rules::cells_move(problem)) return indenter::sliding_threshold(indenter::HalfSpace(problem));
  simulation::System system = simulation::system_of(problem);
  system.known_modes = known;
  return simulation::sliding_threshold(system);
}

// As quickly as it is found: below a measured drive without the error of the fit.
CriticalOnset by_simulation(const Problem& problem, simulation::KnownModes* known = nullptr) {
  const simulation::Onset onset = sliding_threshold(problem, known);
  const bool by_phase = rules::cells_move_one_another(problem);
  CriticalOnset result{
      by_phase ? CriticalOnset::By::maximum_over_the_phase : CriticalOnset::By::simulation,
      onset.contact_velocity,
      onset.drive_velocity,
      std::numeric_limits<double>::quiet_NaN(),
      onset.why_infinite,
      onset.contact_velocity};
  if (std::isfinite(onset.contact_velocity))
    result.relative_error = onset.uncertainty / onset.contact_velocity;
  return result;
}

CriticalOnset found_onset(const Problem& problem, simulation::KnownModes* known) {
  return holds_formula(problem) ? by_formula(problem) : by_simulation(problem, known);
}

// Digits of a simulated v* where its own estimate says nothing; a relative slope with an error
// above this has too few.
constexpr double usual_error = 1e-13, worst_slope_error = 1e-3;

double simulated_log_derivative(const Problem& problem, const Symbol& symbol) {
  const std::string name = to_text(as_called(problem, symbol));
  simulation::KnownModes known;
  const CriticalOnset here = by_simulation(problem, &known);
  if (!(here.contact_velocity > 0 && std::isfinite(here.contact_velocity)))
    throw ModelError("v* is 0 or infinite, so that it has no relative sensitivity");
  const double* const found = problem.values().find(symbol);
  if (found == nullptr) return 0;  // an element of value 0, which is left out
  const Variation changing(problem, {name});
  const double value = *found;
  const auto log_velocity = [&](double logarithm) -> std::optional<double> {
    const double changed = value * std::exp(logarithm);
    try {
      return std::log(found_onset(changing.at({&changed, 1}), &known).contact_velocity);
    } catch (const ModelError&) {
      return std::nullopt;
    }
  };
  const Slope slope = slope_at_zero(log_velocity, std::max(usual_error, here.relative_error));
  if (slope.error <= worst_slope_error * std::max(1.0, std::abs(slope.value))) return slope.value;
  if (std::isinf(slope.error))
    throw ModelError(
        fmt::format("no sensitivity to {}: beside this value of it v* is not found", name));
  throw ModelError(
      fmt::format(
          "the sensitivity to {} is not known to three digits: the simulated v* bends here, "
          "or has too few digits; below it is {:.3g}, above {:.3g}, with errors up to {:.1g}",
          name, slope.below, slope.above, slope.error),
      fmt::format("another value of {}", name));
}

// By the ratio of stiffnesses, which is not bounded as Poisson's ratio is. Under a rigid drive an
// isotropic contact point follows in inverse proportion to it.
double poisson_log_derivative(const Problem& problem, const Isotropic& isotropic) {
  const double nu = *isotropic.quantity.value, by_ratio = -nu / ((1 - nu) * (2 - nu));
  if (problem->rigid()) return -by_ratio;
  const Problem given_by_ratio = with_isotropic(
      problem, {Isotropic::By::ratio, {isotropic.quantity.symbol, tangential_ratio(isotropic)}});
  return by_ratio * simulated_log_derivative(given_by_ratio, isotropic.quantity.symbol);
}

}  // namespace

const char* to_text(CriticalOnset::By by) {
  switch (by) {
    case CriticalOnset::By::formula:
      return "formula";
    case CriticalOnset::By::maximum_over_the_phase:
      return "maximum over the phase";
    case CriticalOnset::By::simulation:
      return "simulation";
  }
  throw Bug("a way to v* without a name");
}

std::vector<int> free_harmonics(const Problem& problem) {
  const ReducedNetwork* drive = problem->drive_network();
  if (drive == nullptr || !rules::answer(rules::Question::all_frequencies, problem)) return {};
  const Values& values = problem.values();
  const double mass = problem->mass ? values.at(problem->mass->symbol) : 0;
  const double omega = values.at(problem->angular_frequency.symbol);
  if (rules::drive_resonates(problem)) return free_harmonics_of_masses(*drive, values, mass, omega);
  const int n = simulation::free_harmonic(relaxation_form(drive->network(), values), mass, omega,
                                          simulation::equal_in_roundings * epsilon);
  return n > 1 ? std::vector{n} : std::vector<int>{};
}

double sliding_share(const std::vector<int>& free_harmonics) {
  const auto least = least_maximum(free_harmonics);
  return least ? least->upper : std::numeric_limits<double>::quiet_NaN();
}

CriticalOnset critical_onset(const Problem& problem, simulation::KnownModes* known) {
  CriticalOnset onset = found_onset(problem, known);
  if (onset.by == CriticalOnset::By::simulation && problem->receptance() != nullptr &&
      std::isfinite(onset.contact_velocity))
    onset.relative_error += realised_velocity(problem).difference / onset.contact_velocity;
  return onset;
}

CertifiedVelocity certified_onset(const Problem& problem) {
  if (holds_formula(problem)) return certified_critical_velocity(problem);
  const CriticalOnset onset = by_simulation(problem);
  return {onset.contact_velocity, onset.relative_error_bound, onset.reason};
}

double quick_onset(const Problem& problem, double omega) {
  const Problem there = problem.with({{problem->angular_frequency.symbol, omega}});
  return holds_formula(there) ? critical_velocity(there) : by_simulation(there).contact_velocity;
}

double onset_log_derivative(const Problem& problem, const Symbol& symbol) {
  check_symbol(problem, symbol);
  if (holds_formula(problem)) return log_derivative(problem, symbol);
  const auto* isotropic = std::get_if<Isotropic>(&problem->tangential);
  const bool held = rules::cells_move_one_another(problem);  // a half-space has no other ratio
  if (isotropic != nullptr && isotropic->by == Isotropic::By::poisson && !held &&
      isotropic->quantity.symbol == symbol)
    return poisson_log_derivative(problem, *isotropic);
  return simulated_log_derivative(problem, symbol);
}

}  // namespace vcrit
