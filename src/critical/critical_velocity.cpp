#include "critical/critical_velocity.hpp"

#include <fmt/core.h>

#include <cmath>
#include <limits>

#include "base/complex.hpp"
#include "critical/certified.hpp"
#include "critical/eq24.hpp"
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

/// Eq. (24) in doubles; v is what mu0 omega du_z is multiplied by.
struct InDoubles {
  Problem problem;
  const Values& values;
  double omega;

  static double outer() { return 1; }
  static double ratio(const Isotropic& isotropic) { return tangential_ratio(isotropic); }
  ComplexDouble normal() const {
    return dynamic_stiffness(problem->normal.reduction(), values, omega);
  }
  ComplexDouble tangential(const ReducedNetwork& own) const {
    return dynamic_stiffness(own.reduction(), values, omega);
  }
  static ComplexDouble scaled(double ratio, ComplexDouble normal) { return ratio * normal; }
  void times_mount(double& v, ComplexDouble normal, const ReducedNetwork& network) const {
    const ComplexDouble mount = dynamic_stiffness(network.reduction(), values, omega);
    const double mass = problem->mount_mass ? values.at(problem->mount_mass->symbol) : 0;
    const double whole = minus_inertia(mount.real(), normal.real(), mass, omega);
    v *= std::abs(mount) / std::hypot(whole, mount.imag() + normal.imag());
  }
  static void divide(double& v, double ratio) { v /= ratio; }
  static void times_quotient(double& v, ComplexDouble normal, ComplexDouble tangential) {
    v *= std::abs(normal) / std::abs(tangential);
  }
  void times_drive(double& v, ComplexDouble tangential, const ReducedNetwork& network) const {
    const ComplexDouble drive = dynamic_stiffness(network.reduction(), values, omega);
    const double n = minus_inertia(tangential.real(), drive.real(), mass(), omega);
    const double d = minus_inertia(drive.real(), mass(), omega);
    v *= std::hypot(n, tangential.imag() + drive.imag()) / std::hypot(d, drive.imag());
  }

  // With K_d = 1/R: |K_t R + 1 - m omega^2 R|/|1 - m omega^2 R|
  void times_drive(double& v, ComplexDouble tangential, const Receptance& measured) const {
    const auto [below, above] = bracket(measured, omega);
    const double width = above.omega - below.omega;
    const double share = width > 0 ? (omega - below.omega) / width : 0;
    const ComplexDouble receptance =
        (1 - share) * ComplexDouble{below.re, below.im} + share * ComplexDouble{above.re, above.im};
    const ComplexDouble d = 1.0 - mass() * omega * omega * receptance;
    v *= std::abs(tangential * receptance + d) / std::abs(d);
  }

 private:
  double mass() const { return problem->mass ? values.at(problem->mass->symbol) : 0; }
};

}  // namespace

double critical_velocity(const Problem& problem, double omega) {
  if (!(omega > 0 && std::isfinite(omega)))
    throw InputError({name_in(problem, problem->angular_frequency)}, fmt::format("{} rad/s", omega),
                     "a finite value above 0");
  const Values& values = problem.values();
  const double friction = values.at(problem->coefficient.symbol);
  const double amplitude = values.at(problem->amplitude.symbol);
  const double v = friction * omega * amplitude * eq24(problem, InDoubles{problem, values, omega});
  if (std::isfinite(v)) return v;
  // Infinite, 0/0, or a number on the way that no double holds.
  try {
    return certified_critical_velocity(problem.with({{problem->angular_frequency.symbol, omega}}))
        .value;
  } catch (const ModelError&) {
    return std::numeric_limits<double>::quiet_NaN();
  }
}

double critical_velocity(const Problem& problem) {
  const Values& values = problem.values();
  return critical_velocity(problem, values.at(problem->angular_frequency.symbol));
}

}  // namespace vcrit
