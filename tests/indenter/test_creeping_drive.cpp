// An indenter on a drive that carries no load at rest: it creeps, and all the faster the drive has
// to move for the contact to slide.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>
#include <vector>

#include "indenter/rim_friction.hpp"
#include "support/scene_text.hpp"

BOOST_AUTO_TEST_SUITE(test_creeping_drive)

namespace {

using namespace vcrit;
using namespace vcrit::indenter;

constexpr double pi = std::numbers::pi;
constexpr double modulus = 0.91 / (1 - 0.3 * 0.3), shear_ratio = 2 * (1 - 0.3) / (2 - 0.3);

// A parabola of radius 1, 1 deep, at omega = 1.
HalfSpace held(const char* network, const test::Elements& drive, double amplitude = 0.8) {
  test::SceneText text{.normal = "spring(E0)",
                       .poisson = 0.3,
                       .separation = true,
                       .indenter = "shape = \"parabola\"\nradius = 1\n",
                       .network = network,
                       .angular_frequency = 1,
                       .amplitude = amplitude,
                       .coefficient = 0.3,
                       .elements = drive};
  text.elements.emplace_back("E0", 0.91);
  return HalfSpace(test::scene_of(text));
}

// By Fourier's series of F_n = 4/3 E* u^(3/2), analytic on the circle, and Maxwell's branches, of
// which each has its damper's share of the mean force: v* at the contact and at the drive.
std::pair<double, double> by_harmonics(const std::vector<std::pair<double, double>>& branches) {
  constexpr int samples = 512, harmonics = 100, phases = 20'000;
  std::vector<std::complex<double>> rates(harmonics);
  double mean = 0, dampers = 0;
  for (int n = 0; n < harmonics; ++n) {
    const std::complex<double> s(0, n);
    std::complex<double> force = 0, drive = 0;
    for (int i = 0; i < samples; ++i) {
      const double t = 2 * pi * i / samples;
      force += 4.0 / 3 * modulus * std::pow(1 + 0.8 * std::cos(t), 1.5) * std::polar(1.0, -n * t);
    }
    force /= samples;
    if (n == 0) mean = force.real();
    for (const auto& [k, c] : branches) drive += k * s / (s + k / c);
    if (n > 0) rates[static_cast<std::size_t>(n)] = 2.0 * s * force / drive;
  }
  for (const auto& [k, c] : branches) dampers += c;
  double most = 0;
  for (int i = 0; i < phases; ++i) {
    const double t = 2 * pi * i / phases;
    double rate = -0.8 * std::sin(t) / shear_ratio;
    for (int n = 1; n < harmonics; ++n)
      rate += (rates[static_cast<std::size_t>(n)] * std::polar(1.0, n * t)).real();
    most = std::max(most, 0.3 * rate);
  }
  return {most, most + 0.3 * mean / dampers};
}

}  // namespace

// 20,000 phases: flat to 1e-8.
BOOST_AUTO_TEST_CASE(a_body_without_mass_on_springs_behind_dampers) {
  const auto check = [](const HalfSpace& half_space, const auto& branches) {
    const auto [contact, drive] = by_harmonics(branches);
    const simulation::Onset onset = rim_threshold(half_space);
    BOOST_TEST(onset.contact_velocity == contact, boost::test_tools::tolerance(3e-8));
    BOOST_TEST(onset.drive_velocity == drive, boost::test_tools::tolerance(3e-8));
    BOOST_TEST(friction(half_space, 0.98 * drive).ratio < 1);
    BOOST_TEST(friction(half_space, 1.02 * drive).ratio == 1);
  };
  check(held("k1 - c1", {{"k1", 0.7}, {"c1", 1.3}}), std::vector{std::pair(0.7, 1.3)});
  check(held("(k1 - c1) | (k2 - c2)", {{"k1", 0.7}, {"c1", 1.3}, {"k2", 2}, {"c2", 30}}),
        std::vector{std::pair(0.7, 1.3), std::pair(2.0, 30.0)});
}

// A faint damper beside them, of a hundred thousandth, changes friction by as little: the body then
// has a rate of its own.
BOOST_AUTO_TEST_CASE(friction_is_that_of_a_faint_damper_beside_them) {
  const HalfSpace alone = held("k1 - c1", {{"k1", 0.7}, {"c1", 1.3}}),
                  beside = held("(k1 - c1) | ce", {{"k1", 0.7}, {"c1", 1.3}, {"ce", 1e-5}});
  const double critical = rim_threshold(alone).drive_velocity;
  for (const double share : {0.2, 0.5, 0.8})
    BOOST_TEST(std::abs(friction(alone, share * critical).ratio -
                        friction(beside, share * critical).ratio) < 1e-4);
}

// While the dampers take less than the closed cells always carry, 4/3 E* (1/5)^(3/2), all of these
// stick, and the mean friction is c v. Without an oscillation it is up to mu0 F_n/c.
BOOST_AUTO_TEST_CASE(a_slow_drive_creeps_alone) {
  const double least = 4.0 / 3 * modulus * std::pow(0.2, 1.5), unit = 0.3 * least / 1.3;
  const auto check = [](const HalfSpace& half_space, double velocity, double carried) {
    const Friction found = friction(half_space, velocity);
    BOOST_TEST(found.ratio * 0.3 * found.normal_force == carried,
               boost::test_tools::tolerance(1e-12));
    BOOST_TEST((found.regime == simulation::Regime::stick));
  };
  const HalfSpace spring = held("k1 - c1", {{"k1", 0.7}, {"c1", 1.3}});
  for (const double share : {1e-6, 0.5, 0.999}) {
    check(spring, share * unit, share * 0.3 * least);
    check(held("cd", {{"cd", 1.3}}), share * unit, share * 0.3 * least);
  }
  // Faster, all cells slide in each period, and the body creeps by less than the drive goes.
  const Friction faster = friction(spring, 3 * unit);
  BOOST_TEST(faster.ratio * 0.3 * faster.normal_force < 0.95 * 3 * 0.3 * least);
  BOOST_TEST(friction(spring, 2 * rim_threshold(spring).drive_velocity).ratio == 1);
  const HalfSpace still = held("k1 - c1", {{"k1", 0.7}, {"c1", 1.3}}, 0);
  const double whole = 4.0 / 3 * modulus;
  check(still, 0.9 * 0.3 * whole / 1.3, 0.9 * 0.3 * whole);
  BOOST_TEST(friction(still, 1.1 * 0.3 * whole / 1.3).ratio == 1);
  BOOST_TEST(rim_threshold(still).contact_velocity == 0);
  BOOST_TEST(rim_threshold(still).drive_velocity == 0.3 * whole / 1.3,
             boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_SUITE_END()
