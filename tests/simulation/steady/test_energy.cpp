// Heat of friction and of dampers in cases that have a closed form.
#include "simulation/steady/energy.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <tuple>

BOOST_AUTO_TEST_SUITE(test_energy)

namespace {

using namespace vcrit;
using namespace vcrit::simulation;

constexpr double u = 1.1e-16, pi = std::numbers::pi;

// mu0 <F_n> = 3 N, the bound 3 (1 + 0.8 cos t) N.
System under(const Relaxation& contact, double omega) {
  System system;
  system.contact = contact;
  system.omega = omega;
  system.friction = 0.5;
  system.mean_normal_force = 6;
  system.normal_force_amplitude = std::polar(6 * 0.8, 1.0);
  return system;
}

// The estimate counts the rounding of the phase of what could swing, `swings` times a period.
void check(const EnergyBalance& energy, double friction, double dampers, double swings = 1) {
  const double work = friction + dampers, tolerance = 40 * u * work;
  BOOST_TEST(std::abs(energy.drive - work) <= tolerance);
  BOOST_TEST(std::abs(energy.friction - friction) <= tolerance);
  BOOST_TEST(std::abs(energy.dampers - dampers) <= tolerance);
  BOOST_TEST(energy.error <= 100 * tolerance * swings);
}

}  // namespace

// Sliding, the force on a Kelvin contact is the bound, its deformation swings by 3 * 0.8/|k + i c
// w|; the damper takes pi c w times the square of that, the rest is heat of friction.
BOOST_AUTO_TEST_CASE(kelvin_contact_in_sliding) {
  const double k = 2, c = 0.3, omega = 7, velocity = 40;
  const double swing = 3 * 0.8 / std::hypot(k, c * omega);
  const double dampers = pi * c * omega * swing * swing;
  check(energy_balance(under({k, c, {}}, omega), velocity).value(),
        velocity * 3 * 2 * pi / omega - dampers, dampers);
}

// A body on a damped drive swings by 3 * 0.8/|k_d - m w^2 + i c_d w| in sliding. The light one
// would swing 1.1 million times for each of the oscillation on its own, but comes to rest within
// 300.
BOOST_AUTO_TEST_CASE(drive_with_a_damper_in_sliding) {
  const double k = 5, omega = 2, velocity = 40;
  for (const auto& [m, c, swings] : {std::tuple(0.6, 0.2, 1.0), std::tuple(1e-12, 1e-7, 1.2e6)}) {
    System system = under({1, 0, {}}, omega);
    system.drive = Relaxation{k, c, {}};
    system.mass = m;
    const double swing = 3 * 0.8 / std::hypot(k - m * omega * omega, c * omega);
    const double dampers = pi * c * omega * swing * swing;
    check(energy_balance(system, velocity).value(), velocity * 3 * 2 * pi / omega - dampers,
          dampers, swings);
  }
}

// So it does on a drive with a Maxwell branch, K_d = k + k_1 i x/(1 + i x), x = w tau, whose damper
// takes pi Im K_d times the square of it.
BOOST_AUTO_TEST_CASE(drive_with_a_branch_in_sliding) {
  const double k = 5, branch = 3, omega = 2, m = 0.6, velocity = 40;
  for (const double time : {0.02, 0.7, 40.0}) {
    System system = under({1, 0, {}}, omega);
    system.drive = Relaxation{k, 0, {{branch, time}}};
    system.mass = m;
    const double x = omega * time, loss = branch * x / (1 + x * x);
    const double swing = 3 * 0.8 / std::hypot(k + loss * x - m * omega * omega, loss);
    const double dampers = pi * loss * swing * swing;
    check(energy_balance(system, velocity).value(), velocity * 3 * 2 * pi / omega - dampers,
          dampers);
  }
}

// Undamped it goes on, and nobody would wait for the sum of it.
BOOST_AUTO_TEST_CASE(swings_without_end_are_not_followed) {
  System system = under({1, 0, {}}, 2);
  system.drive = Relaxation{5, 0, {}};
  system.mass = 1e-12;
  BOOST_TEST(!energy_balance(system, 40).has_value());
}

// An elastic contact has friction alone.
BOOST_AUTO_TEST_CASE(elastic_contact_has_no_dampers) {
  const EnergyBalance energy = energy_balance(under({2, 0, {}}, 1), 0.4).value();
  BOOST_TEST(energy.dampers == 0.0);
  BOOST_TEST(std::abs(energy.drive - energy.friction) <= 40 * u * energy.drive);
}

BOOST_AUTO_TEST_CASE(energy_beyond_doubles_is_none) {
  BOOST_TEST(!energy_balance(under({2, 0, {}}, 1), 1e308).has_value());
}

// A damper alone carries F = min(eta v0, b) and creeps at F/eta, the contact slips at v0 - F/eta:
// with f = eta v0/3 and the bound below f for |t - pi| < a, cos a = (1 - f)/0.8, in units of 9/eta:
// <F^2> = (f^2 (pi - a) + a - 1.6 sin a + 0.32 (a + sin a cos a))/pi, <F> = (f (pi - a) + a - 0.8
// sin a)/pi.
BOOST_AUTO_TEST_CASE(damper_alone) {
  const double eta = 0.7, f = 0.6, velocity = 3 * f / eta;
  const double a = std::acos((1 - f) / 0.8);
  const double mean = (f * (pi - a) + a - 0.8 * std::sin(a)) / pi;
  const double square =
      (f * f * (pi - a) + a - 1.6 * std::sin(a) + 0.32 * (a + std::sin(a) * std::cos(a))) / pi;
  const double unit = 2 * pi * 9 / eta;
  check(energy_balance(under({0, eta, {}}, 1), velocity).value(), unit * (f * mean - square),
        unit * square);
}

// Below the bound it creeps for ever.
BOOST_AUTO_TEST_CASE(damper_alone_that_never_slips) {
  const double eta = 0.7, velocity = 0.1;
  check(energy_balance(under({0, eta, {}}, 1), velocity).value(), 0,
        eta * velocity * velocity * 2 * pi);
}

BOOST_AUTO_TEST_SUITE_END()
