#include "design/opening.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <complex>
#include <cstdint>

#include "answers/critical_onset.hpp"
#include "base/constants.hpp"
#include "rules/rulebook.hpp"

namespace vcrit::design {

namespace {

// Any value will do where none is asked for.
Scene complete(Scene scene) {
  for (Quantity* quantity : {&scene.amplitude, &scene.angular_frequency})
    if (!quantity->value) quantity->value = 1;
  return scene;
}

double at_infinity(const Relaxation& form) {
  if (form.damper > 0) return infinity;
  double sum = form.equilibrium;
  for (const MaxwellBranch& branch : form.branches) sum += branch.stiffness;
  return sum;
}

}  // namespace

NormalContact::NormalContact(const Scene& scene) : scene_(scene) {
  const Values values = values_of(complete(scene));
  normal_ = relaxation_form(scene.normal, values);
  indentation_ = values.at(scene.indentation.symbol);
  rules::require(rules::Question::mean_load, complete(scene));
}

double NormalContact::largest_amplitude(double omega) const {
  return normal_.equilibrium * indentation_ / std::abs(dynamic_stiffness(normal_, omega));
}

std::optional<double> NormalContact::largest_angular_frequency(double amplitude) const {
  rules::require(rules::Question::closed_range, with_amplitude(complete(scene_), amplitude));
  // Below the amplitude, the indentation may round to it.
  const double allowed = std::max(normal_.equilibrium * indentation_ / amplitude,
                                  std::nextafter(normal_.equilibrium, infinity));
  if (at_infinity(normal_) <= allowed) return std::nullopt;
  const auto above = [&](double logarithm) {
    return std::log(std::abs(dynamic_stiffness(normal_, std::exp(logarithm))) / allowed);
  };
  double low = 0, high = 0;
  for (double step = 1; above(low) >= 0; step *= 2) low -= step;
  for (double step = 1; above(high) <= 0 && high < 700; step *= 2) high += step;
  if (high >= 700) return std::nullopt;
  std::uintmax_t steps = 200;
  return std::exp(boost::math::tools::toms748_solve(
                      above, low, high, boost::math::tools::eps_tolerance<double>(50), steps)
                      .first);
}

double NormalContact::oscillating_part(double amplitude, double omega) const {
  return amplitude / largest_amplitude(omega);
}

Scene with_amplitude(Scene scene, double amplitude) {
  scene.amplitude.value = amplitude;
  return scene;
}

Scene with_angular_frequency(Scene scene, double omega) {
  scene.angular_frequency.value = omega;
  return scene;
}

double reduced_up_to(const Scene& scene) { return critical_onset(scene).drive_velocity; }

}  // namespace vcrit::design
