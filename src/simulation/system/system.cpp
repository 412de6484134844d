#include "simulation/system/system.hpp"

#include <cmath>

#include "base/constants.hpp"
#include "normal/mean_indentation.hpp"
#include "normal/mount.hpp"
#include "rules/rulebook.hpp"

namespace vcrit::simulation {

namespace {

// What is left above a share of 1 is rounding.
void let_open(System& system, const Problem& problem, const Relaxation& normal, double amplitude) {
  const double share = std::abs(system.normal_force_amplitude) / system.mean_normal_force;
  if (problem->separation && share > 1 + least_separation(false))
    system.opening = {normal, mean_indentation(problem), amplitude};
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

double glassy_stiffness(const Relaxation& form) {
  double sum = form.equilibrium;
  for (const MaxwellBranch& branch : form.branches) sum += branch.stiffness;
  return sum;
}

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

// Where Re K_d = m s^2 the network of the drive, springs and dampers, answers to a share of 1e-5
// alike over a tenth of the frequency if its loss is as faint; and as no such network stiffens as
// fast as inertia does, there is one place only, to which these steps lead.
int nearly_free_harmonic(const System& system) {
  constexpr double near_harmonic = 1e-5;
  constexpr int most_steps = 50;
  if (!system.drive || !system.mass || !(*system.mass > 0)) return 0;
  const auto stiffness = [&](double s) { return dynamic_stiffness(*system.drive, s); };
  double swing = std::sqrt(glassy_stiffness(*system.drive) / *system.mass);
  for (int i = 0; i < most_steps; ++i) swing = std::sqrt(stiffness(swing).real() / *system.mass);
  const double n = std::round(swing / system.omega);
  if (!(n >= 1 && n <= 1e6)) return 0;
  const double s = n * system.omega, inertia = *system.mass * s * s;
  return std::abs(stiffness(s) - inertia) <= near_harmonic * inertia ? static_cast<int>(n) : 0;
}

System system_of(const Problem& problem) {
  rules::require(rules::Question::motion, problem);
  const Values& values = problem.values();
  const double amplitude = contact_amplitude(problem);
  const Relaxation normal = relaxation_form(problem->normal.network(), values);
  const ScaledNetwork tangential = tangential_network(problem);

  System system;
  system.contact = scaled(relaxation_form(tangential.network.network(), values), tangential.factor);
  system.omega = values.at(problem->angular_frequency.symbol);
  system.friction = values.at(problem->coefficient.symbol);
  system.mean_normal_force = closed_mean_force(problem, normal.equilibrium);
  system.normal_force_amplitude = amplitude * dynamic_stiffness(normal, system.omega);
  if (const ReducedNetwork* drive = problem->drive_network()) {
    system.drive = relaxation_form(drive->network(), values);
    if (problem->mass) system.mass = values.at(problem->mass->symbol);
  }
  let_open(system, problem, normal, amplitude);
  return system;
}

}  // namespace vcrit::simulation
