#include "critical/conditioning.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "base/constants.hpp"
#include "network/masses.hpp"
#include "stiffness/dynamic_stiffness.hpp"

namespace vcrit {

namespace {

/// The same for a measured drive, of which the table's numbers count.
double measured_condition(const Receptance& measured, std::complex<double> contact, double inertia,
                          double omega) {
  const auto [below, above] = bracket(measured, omega);
  const double width = above.omega - below.omega;
  const double share = width > 0 ? (omega - below.omega) / width : 0;
  const std::complex<double> first(below.re, below.im), second(above.re, above.im);
  const std::complex<double> receptance = (1 - share) * first + share * second;
  // The shares are differences of angular frequencies: their errors count like those of omega.
  const double steepness = width > 0 ? omega / width * std::abs(second - first) : 0;
  const double error = (1 - share) * std::abs(first) + share * std::abs(second) + steepness;
  const std::complex<double> d = 1.0 - inertia * receptance;
  return inertia * (error + 3 * std::abs(receptance)) * (1 / std::abs(d)) +
         (std::abs(contact) + inertia) * (error + 3 * std::abs(receptance)) /
             std::abs(contact * receptance + d);
}

}  // namespace

double condition_number(const Problem& problem, const Values& values) {
  constexpr double root = std::numbers::sqrt2;
  const double least = 3 + 2 * root;
  if (problem->rigid()) return least;
  const double omega = values.at(problem->angular_frequency.symbol);
  const double inertia = problem->mass ? values.at(problem->mass->symbol) * omega * omega : 0;
  const auto [network, factor] = tangential_network(problem);
  const auto contact = factor * dynamic_stiffness(network.reduction(), values, omega);
  if (const Receptance* measured = problem->receptance())
    return least + measured_condition(*measured, contact, inertia, omega);
  const Reduction& reduction = problem->drive_network()->reduction();
  const auto drive = dynamic_stiffness(reduction, values, omega);
  // Springs and masses cancel inside the drive.
  const double loss = problem->has_masses() ? sensitivity(reduction, values, omega) : root * std::abs(drive);
  const double d = std::abs(drive - inertia), n = std::abs(contact + drive - inertia);
  const double condition =
      least + (loss + 3 * inertia) / d + (root * std::abs(contact) + loss + 3 * inertia) / n;
  // Where the drive does not give at all, an absorber, doubles divide infinity by infinity.
  return std::isnan(condition) ? infinity : condition;
}

double formula_tolerance(double condition) { return 32 * (epsilon / 2) * condition; }

double motion_tolerance(double condition) {
  return std::max(motion_promise, formula_tolerance(condition));
}

bool leaves_digits(double tolerance) { return tolerance < 1; }

}  // namespace vcrit
