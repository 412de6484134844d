#include "critical/critical_velocity.hpp"

#include <fmt/core.h>

#include <cmath>

#include "base/complex.hpp"
#include "stiffness/dynamic_stiffness.hpp"

namespace vcrit {

namespace {

// K_d - m omega^2 with the product's rounding errors kept, so that resonance loses no digits.
double minus_inertia(double stiffness, double mass, double omega) {
  const double square = omega * omega, square_error = std::fma(omega, omega, -square);
  const double inertia = mass * square, inertia_error = std::fma(mass, square, -inertia);
  return (stiffness - inertia) - (inertia_error + mass * square_error);
}

// The exact sum of two doubles is sum + rest.
double minus_inertia(double a, double b, double mass, double omega) {
  const double sum = a + b, shadow = sum - a;
  const double rest = (a - (sum - shadow)) + (b - shadow);
  return minus_inertia(sum, mass, omega) + rest;
}

// |K_t + K_d - m omega^2|/|K_d - m omega^2|
double drive_factor(ComplexDouble tangential, const Scene& scene, const Values& values,
                    double omega) {
  const ComplexDouble drive = dynamic_stiffness(*scene.drive, values, omega);
  const double mass = scene.mass ? values.at(scene.mass->symbol) : 0;
  const double n = minus_inertia(tangential.real(), drive.real(), mass, omega);
  const double d = minus_inertia(drive.real(), mass, omega);
  return std::hypot(n, tangential.imag() + drive.imag()) / std::hypot(d, drive.imag());
}

// The same with K_d = 1/R: |K_t R + 1 - m omega^2 R|/|1 - m omega^2 R|
double measured_factor(ComplexDouble tangential, const Scene& scene, const Values& values,
                       double omega) {
  const auto [below, above] = bracket(*scene.receptance, omega);
  const double width = above.omega - below.omega;
  const double share = width > 0 ? (omega - below.omega) / width : 0;
  const ComplexDouble receptance =
      (1 - share) * ComplexDouble{below.re, below.im} + share * ComplexDouble{above.re, above.im};
  const double inertia = scene.mass ? values.at(scene.mass->symbol) * omega * omega : 0;
  const ComplexDouble d = 1.0 - inertia * receptance;
  return std::abs(tangential * receptance + d) / std::abs(d);
}

}  // namespace

double critical_velocity(const Scene& scene, double omega) {
  if (!(omega > 0 && std::isfinite(omega)))
    throw InputError({"omega"}, fmt::format("{} rad/s", omega), "a finite value above 0");
  const Values values = values_of(scene);
  const double friction = values.at(scene.coefficient.symbol);
  const double amplitude = values.at(scene.amplitude.symbol);
  const auto* isotropic = std::get_if<Isotropic>(&scene.tangential);
  const double ratio = isotropic != nullptr ? tangential_ratio(*isotropic) : 1;

  // An isotropic, rigidly driven contact needs no rheology at all.
  double factor = 1 / ratio;
  if (isotropic == nullptr || has_drive(scene)) {
    const ComplexDouble normal = dynamic_stiffness(scene.normal, values, omega);
    const ComplexDouble tangential =
        isotropic != nullptr
            ? ratio * normal
            : dynamic_stiffness(std::get<Network>(scene.tangential), values, omega);
    if (isotropic == nullptr) factor = std::abs(normal) / std::abs(tangential);
    if (scene.drive) factor *= drive_factor(tangential, scene, values, omega);
    if (scene.receptance) factor *= measured_factor(tangential, scene, values, omega);
  }
  return friction * omega * amplitude * factor;
}

double critical_velocity(const Scene& scene) {
  const Values values = values_of(scene);
  return critical_velocity(scene, values.at(scene.angular_frequency.symbol));
}

}  // namespace vcrit
