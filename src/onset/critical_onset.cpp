#include "onset/critical_onset.hpp"

#include <cmath>
#include <limits>

#include "base/constants.hpp"
#include "critical/admissibility.hpp"
#include "critical/certified.hpp"
#include "critical/log_derivative.hpp"
#include "indenter/friction.hpp"
#include "network/masses.hpp"
#include "onset/formula_scope.hpp"
#include "scene/changing.hpp"
#include "simulation/steady/onset.hpp"

namespace vcrit {

namespace {

// Of a body on springs, whose contact never opens.
int free_harmonic(const Scene& scene) {
  if (!scene.mass || !scene.drive || scene.receptance || has_masses(*scene.drive)) return 0;
  const Values values = values_of(scene);
  return simulation::free_harmonic(relaxation_form(*scene.drive, values),
                                   values.at(scene.mass->symbol),
                                   values.at(scene.angular_frequency.symbol));
}

CriticalOnset by_formula(const Scene& scene) {
  const auto [value, bound, reason] = certified_critical_velocity(scene);
  CriticalOnset onset{
      CriticalOnset::By::formula, value, value + creep_velocity(scene), bound, reason, value};
  if (const int n = free_harmonic(scene); n > 1) {
    onset.free_harmonic = n;
    onset.sliding_from *= std::cos(pi / (2 * n));
  }
  return onset;
}

CriticalOnset by_simulation(const simulation::Onset& onset) {
  return {CriticalOnset::By::simulation,
          onset.contact_velocity,
          onset.drive_velocity,
          std::numeric_limits<double>::quiet_NaN(),
          onset.why_infinite,
          onset.contact_velocity};
}

// Steps of ln p. Differences of fourth order err by their fourth power, 1e-12, and the 1e-13 to
// which v* is simulated by 1e-10.
constexpr double log_step = 1e-3;

}  // namespace

CriticalOnset critical_onset(const Scene& scene) {
  if (formula_holds(scene)) return by_formula(scene);
  return by_simulation(scene.indenter
                           ? indenter::critical_velocity(indenter::HalfSpace(scene))
                           : simulation::sliding_threshold(simulation::system_of(scene)));
}

double onset_log_derivative(const Scene& scene, const Symbol& symbol) {
  if (formula_holds(scene)) return log_derivative(scene, symbol);
  ChangingScene changing(scene, {to_text(symbol)});
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
