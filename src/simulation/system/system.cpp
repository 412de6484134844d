#include "simulation/system/system.hpp"

#include <cmath>

#include "base/constants.hpp"
#include "rules/rulebook.hpp"

namespace vcrit::simulation {

namespace {

// What is left above a share of 1 is rounding.
void let_open(System& system, bool separates, const Relaxation& normal, double amplitude,
              double indentation) {
  const double share = std::abs(system.normal_force_amplitude) / system.mean_normal_force;
  if (separates && share > 1 + hardly_parting(false))
    system.opening = {normal, indentation, amplitude};
  else if (share > 1)
    system.normal_force_amplitude /= share;
}

// A product as the sum of two doubles, right to 2^-100.
struct Product {
  double high, low = 0;

  void times(double factor) {
    const double next = high * factor;
    low = std::fma(high, factor, -next) + low * factor;
    high = next + low;
    low -= high - next;
  }
};

}  // namespace

int free_harmonic(const Relaxation& drive, double mass, double omega, double within) {
  const auto& [spring, damper, branches] = drive;
  if (!(spring > 0) || !(mass > 0) || damper > 0 || !branches.empty()) return 0;
  const double n = std::round(std::sqrt(spring / mass) / omega);
  if (!(n >= 1 && n <= 1e6)) return 0;
  Product inertia{mass};
  for (const double factor : {n, n, omega, omega}) inertia.times(factor);
  const double off = std::abs((inertia.high - spring) + inertia.low);
  return off <= within * spring ? static_cast<int>(n) : 0;
}

int free_harmonic(const System& system) {
  if (!system.drive || !system.mass) return 0;
  const double within = system.opening ? 1e-30 : equal_in_roundings * epsilon;
  return free_harmonic(*system.drive, *system.mass, system.omega, within);
}

int nearly_free_harmonic(const System& system) {
  constexpr double near_harmonic = 1e-5;
  if (!system.drive || !system.mass) return 0;
  Relaxation undamped = *system.drive;
  undamped.damper = 0;
  const int n = free_harmonic(undamped, *system.mass, system.omega, near_harmonic);
  const double loss = n * system.omega * system.drive->damper;
  return loss <= near_harmonic * undamped.equilibrium ? n : 0;
}

System system_of(const Scene& scene) {
  rules::require(rules::Question::motion, scene);
  const Values values = values_of(scene);
  const double amplitude = values.at(scene.amplitude.symbol);
  const double indentation = values.at(scene.indentation.symbol);
  const Relaxation normal = relaxation_form(scene.normal, values);
  const ScaledNetwork tangential = tangential_network(scene);

  System system;
  system.contact = scaled(relaxation_form(*tangential.network, values), tangential.factor);
  system.omega = values.at(scene.angular_frequency.symbol);
  system.friction = values.at(scene.coefficient.symbol);
  system.mean_normal_force = normal.equilibrium * indentation;
  system.normal_force_amplitude = amplitude * dynamic_stiffness(normal, system.omega);
  if (scene.drive) {
    system.drive = relaxation_form(*scene.drive, values);
    if (scene.mass) system.mass = values.at(scene.mass->symbol);
  }
  let_open(system, scene.separation, normal, amplitude, indentation);
  return system;
}

}  // namespace vcrit::simulation
