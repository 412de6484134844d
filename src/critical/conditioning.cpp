#include "critical/conditioning.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/complex.hpp"
#include "base/constants.hpp"
#include "critical/eq24.hpp"
#include "rules/kinds.hpp"
#include "stiffness/dynamic_stiffness.hpp"

namespace vcrit {

namespace {

/// What the factors of Eq. (24) add to the bound, one after the other.
struct InConditions {
  const Problem& problem;
  const Values& values;
  double omega;

  /// By Tellegen's theorem for a network's |K|.
  static constexpr double root = std::numbers::sqrt2;

  static double outer() { return 3; }
  static double ratio(const Isotropic& isotropic) { return tangential_ratio(isotropic); }
  ComplexDouble normal() const { return stiffness(problem->normal); }
  ComplexDouble tangential(const ReducedNetwork& own) const { return stiffness(own); }
  static ComplexDouble scaled(double ratio, ComplexDouble normal) { return ratio * normal; }
  void times_mount(double& condition, ComplexDouble normal, const ReducedNetwork& network) const {
    const ComplexDouble mount = stiffness(network);
    const double inertia =
        problem->mount_mass ? values.at(problem->mount_mass->symbol) * omega * omega : 0;
    condition += root + (root * (std::abs(normal) + std::abs(mount)) + 3 * inertia) /
                            std::abs(normal + mount - inertia);
  }
  // No more than two networks, of which it is the quotient.
  static void divide(double& condition, double) { condition += 2 * root; }
  static void times_quotient(double& condition, ComplexDouble, ComplexDouble) {
    condition += 2 * root;
  }

  void times_drive(double& condition, ComplexDouble contact, const ReducedNetwork& network) const {
    const ComplexDouble drive = stiffness(network);
    const double loss = rules::drive_resonates(problem)
                            ? sensitivity(network.reduction(), values, omega)
                            : root * std::abs(drive);
    const double d = std::abs(drive - inertia()), n = std::abs(contact + drive - inertia());
    condition += (loss + 3 * inertia()) / d;
    condition += (root * std::abs(contact) + loss + 3 * inertia()) / n;
  }

  // Of a measured drive the table's numbers count.
  void times_drive(double& condition, ComplexDouble contact, const Receptance& measured) const {
    const auto [below, above] = bracket(measured, omega);
    const double width = above.omega - below.omega;
    const double share = width > 0 ? (omega - below.omega) / width : 0;
    const ComplexDouble first(below.re, below.im), second(above.re, above.im);
    const ComplexDouble receptance = (1 - share) * first + share * second;
    // The shares are differences of angular frequencies: their errors count like those of omega.
    const double steepness = width > 0 ? omega / width * std::abs(second - first) : 0;
    const double error = (1 - share) * std::abs(first) + share * std::abs(second) + steepness;
    const ComplexDouble d = 1.0 - inertia() * receptance;
    condition += inertia() * (error + 3 * std::abs(receptance)) * (1 / std::abs(d)) +
                 (std::abs(contact) + inertia()) * (error + 3 * std::abs(receptance)) /
                     std::abs(contact * receptance + d);
  }

 private:
  double inertia() const {
    return problem->mass ? values.at(problem->mass->symbol) * omega * omega : 0;
  }
  ComplexDouble stiffness(const ReducedNetwork& network) const {
    return dynamic_stiffness(network.reduction(), values, omega);
  }
};

}  // namespace

double condition_number(const Problem& problem, const Values& values) {
  const double omega = values.at(problem->angular_frequency.symbol);
  const double condition = eq24(problem, InConditions{problem, values, omega});
  // Where the drive does not give at all, an absorber, doubles divide infinity by infinity.
  return std::isnan(condition) ? infinity : condition;
}

double formula_tolerance(double condition) { return 32 * (epsilon / 2) * condition; }

double motion_tolerance(double condition) {
  return std::max(motion_promise, formula_tolerance(condition));
}

bool leaves_digits(double tolerance) { return tolerance < 1; }

}  // namespace vcrit
