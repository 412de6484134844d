#include "simulation/motion/masses.hpp"

#include <cmath>

namespace vcrit::simulation {

namespace {

Dense<long double> per_radian(Dense<long double> rates, double omega) {
  for (long double& rate : rates.numbers()) rate /= omega;
  return rates;
}

}  // namespace

Masses::Masses(const DriveMotion& motion, double omega, double stiffness_unit)
    : mass(motion.mass * omega * (omega / stiffness_unit)),
      fluidity(motion.fluidity * (stiffness_unit / omega)),
      frequency(omega),
      by_second(motion.rates),
      exact(per_radian(motion.rates, omega)),
      rest(motion.rest.begin(), motion.rest.end()) {
  const Index n = rest.size();
  rates = losses = Matrix(n, n);
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j) {
      rates(i, j) = static_cast<double>(exact(i, j));
      losses(i, j) = static_cast<double>(-(exact(i, j) + exact(j, i)) / 2);
    }
  // A x = F/m e_1; on a spring its end stands still, whatever rounding says.
  for (const std::complex<double>& each : response(exact, 0)) steady.push_back(-each.real() / mass);
  steady[0] = -fluidity;
}

GeneralModes slip_modes(const Masses& masses, KnownModes* known) {
  return general_modes(masses.by_second, masses.frequency, known);
}

// A branch of the contact in units of energy, rho = sqrt(k m) times its number, so that it and the
// body act on each other by sqrt(k/m).
GeneralModes stick_modes(const Masses& masses, const ContactModes& contact, KnownModes* known) {
  const Index n = masses.states(), branches = contact.branch_stiffness.size();
  const long double mass = masses.mass;
  Dense<long double> a(n + branches, n + branches);
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j) a(i, j) = masses.exact(i, j);
  a(0, 0) -= contact.damper / mass;
  for (Index i = 0; i < branches; ++i) {
    const long double link = std::sqrt(contact.branch_stiffness[i] / mass);
    a(0, n + i) = -link;
    a(n + i, 0) = link;
    a(n + i, n + i) = -contact.branch_rates[i];
  }
  GeneralModes result = general_modes(a, 1, known);
  auto& [spectrum, to, from] = result.modes;
  for (Index i = 0; i < branches; ++i) {
    const double unit = std::sqrt(contact.branch_stiffness[i] * masses.mass);
    for (Index j = 0; j < n + branches; ++j) {
      to(j, n + i) /= unit;
      from(n + i, j) *= unit;
    }
  }
  return result;
}

void add_rates(const Masses& masses, ConstView x, double force, View y) {
  y[0] -= force / masses.mass;
  add_product(all(masses.rates), x, y);
}

std::complex<double> mobility(const Masses& masses, std::complex<double> s) {
  return response(masses.exact, s)[0] / masses.mass;
}

// Beside a pole at i the mobility is 1/(2 m (s - i)).
double resonant_mass(const Masses& masses) {
  constexpr double beside = 1e-6;
  return 1 / (2 * beside * std::abs(mobility(masses, {0, 1 + beside})));
}

}  // namespace vcrit::simulation
