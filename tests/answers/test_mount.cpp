// Contacts that a vibrator moves through a mount that gives: amplitude, phase and v* against an
// elimination of the nodes by itself, limits, the motion on both sides of v*, and what is refused.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <set>
#include <string>
#include <utility>

#include "answers/critical_onset.hpp"
#include "answers/effect.hpp"
#include "answers/friction.hpp"
#include "answers/under_load.hpp"
#include "base/errors.hpp"
#include "critical/critical_velocity.hpp"
#include "critical/log_derivative.hpp"
#include "normal/mount.hpp"
#include "rules/rulebook.hpp"
#include "support/refusal.hpp"
#include "support/scene_text.hpp"

BOOST_AUTO_TEST_SUITE(test_mount)

using namespace vcrit;
using Complex = std::complex<long double>;

namespace {

struct Machine {
  double km = 2, cm = 0.3, mn = 0.2, kn = 1.5, cn = 0.2, kt = 1, ct = 0.1, kd = 0.5, cd = 0.05;
  double m = 0.3, omega = 1.3, amplitude = 0.1, force = 1, coefficient = 0.4;
  bool shared = false;  // m_n is the body's m

  test::SceneText text() const {
    return {.normal = "kn | cn",
            .tangential = "kt | ct",
            .network = "kd | cd",
            .mass = m,
            .mount = "km | cm",
            .mount_mass = shared ? test::Toml("m") : test::Toml(mn),
            .angular_frequency = omega,
            .amplitude = amplitude,
            .force = force,
            .coefficient = coefficient,
            .elements = {{"km", km},
                         {"cm", cm},
                         {"kn", kn},
                         {"cn", cn},
                         {"kt", kt},
                         {"ct", ct},
                         {"kd", kd},
                         {"cd", cd}}};
  }
  Problem problem() const { return test::scene_of(text()); }

  Complex along(double k, double c) const {
    return Complex(k, static_cast<long double>(c) * omega);
  }
  long double inertia(double mass) const { return static_cast<long double>(mass) * omega * omega; }
  /// A_z by its own balance: [K_m + K_n - m_n w^2] A_z = K_m U.
  Complex height() const {
    const Complex mount = along(km, cm);
    return mount * static_cast<long double>(amplitude) /
           (mount + along(kn, cn) - inertia(shared ? m : mn));
  }
  /// |i w B|: body and contact point as two nodes under the friction mu0 K_n A_z.
  long double velocity() const {
    const Complex t = along(kt, ct), d = along(kd, cd) - inertia(m);
    const Complex friction = static_cast<long double>(coefficient) * along(kn, cn) * height();
    // [t + d, -t; -t, t] (A, B) = (0, -friction)
    const Complex determinant = (t + d) * t - t * t;
    return omega * std::abs((t + d) * friction / determinant);
  }
};

double log_uniform(std::mt19937& random, double from, double to) {
  std::uniform_real_distribution<double> exponent(std::log(from), std::log(to));
  return std::exp(exponent(random));
}

Machine random_machine(std::mt19937& random) {
  Machine machine;
  for (double* each : {&machine.km, &machine.cm, &machine.kn, &machine.cn, &machine.kt, &machine.ct,
                       &machine.kd, &machine.cd, &machine.mn, &machine.m, &machine.omega})
    *each = log_uniform(random, 0.1, 10);
  machine.shared = random() % 2 == 0;
  return machine;
}

}  // namespace

// Both to a few roundings, times what cancels where springs and masses nearly do: a part in 100 of
// the stiffnesses at these random numbers.
BOOST_AUTO_TEST_CASE(amplitude_phase_and_velocity_are_those_of_the_balances) {
  std::mt19937 random(36);
  for (int i = 0; i < 200; ++i) {
    const Machine machine = random_machine(random);
    const Problem problem = machine.problem();
    const Complex height = machine.height();
    const auto below = below_mount(problem);
    BOOST_REQUIRE(below.has_value());
    BOOST_TEST(below->amplitude == static_cast<double>(std::abs(height)),
               boost::test_tools::tolerance(1e-13));
    BOOST_TEST(std::abs(below->mount_phase - static_cast<double>(std::arg(height))) < 1e-13);
    const auto v = static_cast<double>(machine.velocity());
    BOOST_TEST(certified_critical_velocity(problem).value == v,
               boost::test_tools::tolerance(1e-13));
    BOOST_TEST(critical_velocity(problem) == v, boost::test_tools::tolerance(1e-12));
  }
}

// The sensitivities to all stiffnesses, dampers and masses add up to 0, those to what has a time in
// its unit to 1: v*/U is a speed over a length. Each also by a difference of second order.
BOOST_AUTO_TEST_CASE(sensitivities_are_those_of_the_formula) {
  std::mt19937 random(7);
  for (int i = 0; i < 20; ++i) {
    const Problem problem = random_machine(random).problem();
    double stiffness = 0, time = 0;
    const auto slope = [&](const Symbol& symbol) {
      constexpr double h = 1e-5;
      const double value = problem.values().at(symbol);
      const auto at = [&](double shift) {
        return std::log(critical_velocity(problem.with({{symbol, value * std::exp(shift)}})));
      };
      const double found = log_derivative(problem, symbol);
      BOOST_TEST(
          std::abs(found - (at(h) - at(-h)) / (2 * h)) < 1e-6 * std::max(1.0, std::abs(found)),
          symbol.name);
      return found;
    };
    for (const char* name : {"km", "kn", "kt", "kd"}) stiffness += slope({name});
    for (const char* name : {"cm", "cn", "ct", "cd"}) {
      const double found = slope({name});
      stiffness += found, time += found;
    }
    for (const Symbol& mass :
         std::set<Symbol>{problem->mass->symbol, problem->mount_mass->symbol}) {
      const double found = slope(mass);
      stiffness += found, time += 2 * found;
    }
    BOOST_TEST(std::abs(stiffness) < 1e-10);
    BOOST_TEST(std::abs(slope({"omega"}) - time - 1) < 1e-10);
  }
}

// K_m -> infinity: Eq. (24) of the scene whose height is prescribed, to the ratio of stiffnesses.
BOOST_AUTO_TEST_CASE(a_stiff_mount_is_none) {
  Machine machine;
  machine.km = 1e12;
  test::SceneText given = machine.text();
  given.mount = given.mount_mass = {};
  given.elements.erase(given.elements.begin(), given.elements.begin() + 2);
  const double without = critical_onset(test::scene_of(given)).contact_velocity;
  BOOST_TEST(critical_onset(machine.problem()).contact_velocity == without,
             boost::test_tools::tolerance(1e-11));
}

// K_n -> infinity at fixed K_n/K_t: the amplitude of the force is that of a blocked mount, K_m U.
BOOST_AUTO_TEST_CASE(a_stiff_contact_is_driven_by_a_force) {
  Machine machine;
  machine.kn = 1e9, machine.cn = 0;
  const Problem problem = machine.problem();
  const double force = contact_amplitude(problem) * machine.kn;
  BOOST_TEST(force == machine.amplitude * std::hypot(machine.km, machine.cm * machine.omega),
             boost::test_tools::tolerance(1e-8));
}

// Without mass mount and contact are one behind the other; isotropic, elastic and under a rigid
// drive v* = mu0 omega U (K_n/K_t) K_m/(K_m + K_n).
BOOST_AUTO_TEST_CASE(a_mount_without_mass_is_in_series) {
  const Problem problem = test::scene_of({.normal = "kn",
                                          .tangential_ratio = 0.8,
                                          .mount = "km",
                                          .angular_frequency = 2,
                                          .amplitude = 0.1,
                                          .indentation = 1,
                                          .coefficient = 0.3,
                                          .elements = {{"kn", 3}, {"km", 2}}});
  BOOST_TEST(critical_onset(problem).contact_velocity == 0.3 * 2 * 0.1 / 0.8 * 2 / 5,
             boost::test_tools::tolerance(1e-15));
  const Effect effect = effect_of(problem);
  BOOST_TEST(*effect.contact_amplitude == 0.04, boost::test_tools::tolerance(1e-15));
  // (3) is (4): K_n = K_n(0), u_z0 (K_m + K_n)/K_m of the vibrator.
  BOOST_TEST(*effect.largest_closed_amplitude == 2.5, boost::test_tools::tolerance(1e-15));
}

// The rheology, which cancels without a mount: (K_n/K_t) |K_m/(K_m + K_n)| of a viscoelastic
// contact.
BOOST_AUTO_TEST_CASE(the_rheology_is_back_in_an_isotropic_contact) {
  const auto velocity = [](double c) {
    return critical_onset(test::scene_of({.normal = "kn | cn",
                                          .tangential_ratio = 0.8,
                                          .mount = "km",
                                          .angular_frequency = 2,
                                          .amplitude = 0.1,
                                          .indentation = 1,
                                          .coefficient = 0.3,
                                          .elements = {{"kn", 3}, {"cn", c}, {"km", 2}}}))
        .contact_velocity;
  };
  for (const double c : {0.1, 1.0, 4.0})
    BOOST_TEST(velocity(c) == 0.3 * 2 * 0.1 / 0.8 * 2 / std::hypot(5, 2 * c),
               boost::test_tools::tolerance(1e-15));
}

// Nothing along the surface acts on the height: whatever holds the body, masses in the drive among
// it, v* is that without a mount times |A_z/U|.
BOOST_AUTO_TEST_CASE(a_mount_is_a_factor_of_any_drive) {
  Machine machine;
  for (const std::string drive : {"kd | cd", "kd - (mass(ms) | ks | cd)", "mass(ms) | kd | cd"}) {
    test::SceneText with = machine.text();
    with.network = drive;
    if (drive.find("ms") != std::string::npos) with.elements.push_back({"ms", 0.7});
    if (drive.find("ks") != std::string::npos) with.elements.push_back({"ks", 0.9});
    test::SceneText without = with;
    without.mount = without.mount_mass = {};
    without.elements.erase(without.elements.begin(), without.elements.begin() + 2);
    const auto left = static_cast<double>(std::abs(machine.height())) / machine.amplitude;
    BOOST_TEST(critical_onset(test::scene_of(with)).contact_velocity ==
                   left * critical_onset(test::scene_of(without)).contact_velocity,
               boost::test_tools::tolerance(1e-14));
  }
}

// k_m + k_n = m_n omega^2: the contact's amplitude has no bound.
BOOST_AUTO_TEST_CASE(an_undamped_mount_resonates) {
  const auto scene = [](double mass) -> Problem {
    return test::scene_of({.normal = "kn",
                           .tangential_ratio = 0.8,
                           .mount = "km",
                           .mount_mass = mass,
                           .angular_frequency = 2,
                           .amplitude = 1e-9,
                           .indentation = 1,
                           .coefficient = 0.3,
                           .elements = {{"kn", 3}, {"km", 2}}});
  };
  BOOST_TEST(std::isinf(certified_critical_velocity(scene(1.25)).value));
  BOOST_TEST(!rules::answer(rules::Question::admissible, scene(1.25)));
  BOOST_TEST(std::isfinite(certified_critical_velocity(scene(std::nextafter(1.25, 2))).value));
}

// Below v* the contact sticks, above it slides all the time.
BOOST_AUTO_TEST_CASE(the_motion_changes_at_the_velocity) {
  std::mt19937 random(3);
  for (int i = 0; i < 20; ++i) {
    Machine machine = random_machine(random);
    machine.force =
        3 * static_cast<double>(std::abs(machine.height() * machine.along(machine.kn, machine.cn)));
    const Problem problem = machine.problem();
    const double v = critical_onset(problem).contact_velocity;
    const SteadyFriction friction(problem);
    BOOST_TEST((friction.at(1.001 * v).regime == simulation::Regime::sliding));
    BOOST_TEST((friction.at(0.999 * v).regime != simulation::Regime::sliding));
    BOOST_TEST(friction.at(0.999 * v).friction_ratio < 1);
  }
}

BOOST_AUTO_TEST_CASE(what_is_no_mount_is_refused) {
  const auto said = [](const std::string& mount, test::SceneText text = {}) {
    text.elements = {{"kn", 1}, {"km", 1}, {"cm", 1}, {"mm", 1}};
    text.more = "[mount]\n" + mount;
    return test::refusal([&] { test::scene_of(text); });
  };
  BOOST_TEST(said("network = \"km\"\n") == "accepted");
  BOOST_TEST(test::has(said("network = \"km | mass(mm)\"\n"), "a mass in the mount"));
  BOOST_TEST(test::has(said("network = \"km - cm\"\n"), "K_m(0) = 0"));
  BOOST_TEST(test::has(said("mass = 1.0\n"), "no \"network\" in [mount]"));
  BOOST_TEST(test::has(said("network = \"km\"\n", {.normal = "spring(kn)",
                                                   .indenter = "shape = \"cone\"\nangle = 0.1\n"}),
                       "[indenter] with [mount]"));
}

// By its own name, by the key with its section, and by the body's where it is the body's.
BOOST_AUTO_TEST_CASE(the_moving_mass_has_a_name) {
  Machine machine;
  const test::SceneText text = machine.text();
  const auto mass = [&](const Settings& settings) {
    const Problem problem = test::scene_of(text, settings);
    return *problem->mount_mass->value;
  };
  BOOST_TEST(mass({{"m_n", "0.7"}}) == 0.7);
  BOOST_TEST(mass({{"mount.mass", "0.7"}}) == 0.7);
  BOOST_TEST(mass({{"mass", "0.7"}}) == machine.mn);
  machine.shared = true;
  const Problem problem = test::scene_of(machine.text(), {{"mass", "0.7"}});
  BOOST_TEST(*problem->mount_mass->value == 0.7);
  BOOST_TEST(*problem.with({{problem->mass->symbol, 0.9}})->mount_mass->value == 0.9);
  BOOST_TEST(to_text(as_called(problem, problem->amplitude.symbol)) == "U");
}

BOOST_AUTO_TEST_SUITE_END()
