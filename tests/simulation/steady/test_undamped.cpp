// Bodies on springs alone: in resonance with the oscillation, where stick bounds a swing that would
// grow without end, and swinging freely at a harmonic of it, where sliding needs less speed than
// v*. True values: an event-driven program of 34 digits, marched from rest and from sliding.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "answers/critical_onset.hpp"
#include "base/errors.hpp"
#include "scene/scene.hpp"
#include "simulation/steady/energy.hpp"
#include "simulation/steady/exact.hpp"
#include "simulation/steady/onset.hpp"
#include "support/scene_text.hpp"

BOOST_AUTO_TEST_SUITE(test_undamped)

namespace {

using namespace vcrit;
using namespace vcrit::simulation;

Scene scene_of(const std::string& name) {
  return read_scene(VCRIT_TEST_DATA "/undamped/" + name + ".toml");
}

const System resonant = system_of(scene_of("exact_resonance"));

struct Harmonic {
  std::string name;
  int n;
  double border, ratio_below;  ///< m/s; the friction ratio at 0.99 of it
  double tolerance;
};
const std::vector<Harmonic> harmonics{
    {"undamped_harmonic", 3, 0.0283834259, 0.9999247184321, 1e-12},
    {"undamped_harmonic_4", 2, 0.0286992419, 0.99992394, 2e-8},  // still settling there
    {"undamped_harmonic_2", 2, 0.0277332777, 0.999865734, 5e-10},
};

BOOST_AUTO_TEST_CASE(friction_at_resonance) {
  const std::vector<std::pair<double, double>> known{{0.01, 0.658611445561086403},
                                                     {0.05, 0.703523550377319975}};
  for (const auto& [velocity, ratio] : known)
    for (const Start start : {Start::sliding, Start::rest}) {
      const SteadyState state = steady_state(resonant, velocity, start);
      BOOST_TEST(std::abs(state.friction_ratio - ratio) <= state.friction_ratio_error);
      BOOST_TEST(state.friction_ratio_error < 1e-11);
      BOOST_TEST((state.regime == Regime::stick_slip));
    }
}

// Friction is continuous through the resonance: across it, by what it changes in a step.
BOOST_AUTO_TEST_CASE(friction_next_to_resonance) {
  const SteadyState at = steady_state(resonant, 0.01);
  for (const double detuning : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const auto beside = [&](double share) {
      System system = resonant;
      system.drive->equilibrium *= 1 + share;
      return steady_state(system, 0.01);
    };
    const SteadyState below = beside(-detuning), above = beside(detuning);
    const double error =
        2 * at.friction_ratio_error + below.friction_ratio_error + above.friction_ratio_error;
    const double change = below.friction_ratio + above.friction_ratio - 2 * at.friction_ratio;
    BOOST_TEST(error <= 1e-8);
    BOOST_TEST(std::abs(change) <= error + 10 * detuning * detuning);
    BOOST_TEST(std::abs(above.friction_ratio - at.friction_ratio) <= error + detuning);
  }
}

BOOST_AUTO_TEST_CASE(motion_at_resonance) {
  const SteadyState state = steady_state(resonant, 0.01, Start::sliding, 2000);
  double mean = 0;
  for (const CyclePoint& point : state.cycle) {
    BOOST_TEST(point.contact_velocity >= -1e-9);
    // Next to an event the mean of the neighbours is off by their distance squared, 1e-3^2.
    BOOST_TEST(std::abs(point.force) <= point.friction_bound * (1 + 1e-5));
    mean += point.contact_velocity / 2000;
  }
  // The rectangle rule over a velocity that jumps at each end of stick, by some times its mean.
  BOOST_TEST(std::abs(mean / 0.01 - 1) <= 1e-2);
  const auto energy = energy_balance(resonant, 0.01);
  BOOST_REQUIRE(energy.has_value());
  BOOST_TEST(std::abs(energy->drive - energy->friction - energy->dampers) <= energy->error);
  BOOST_TEST(energy->error <= 1e-9 * energy->drive);
}

BOOST_AUTO_TEST_CASE(sliding_at_a_harmonic_needs_less_than_the_formula_says) {
  for (const auto& [name, n, border, ratio_below, tolerance] : harmonics) {
    const System system = system_of(scene_of(name));
    const CriticalOnset onset = critical_onset(scene_of(name));
    BOOST_TEST(onset.free_harmonics == std::vector{n});
    BOOST_TEST(std::abs(onset.sliding_from / border - 1) <= 1e-8);
    const double share = std::cos(std::numbers::pi / (2 * n));
    BOOST_TEST(std::abs(onset.sliding_from / onset.contact_velocity / share - 1) <= 1e-15);
    BOOST_TEST(std::abs(sliding_threshold(system).contact_velocity / border - 1) <= 1e-8);
    BOOST_CHECK_THROW(stick_onset(system), ModelError);
    const double ratio = steady_state(system, 0.99 * onset.sliding_from).friction_ratio;
    BOOST_TEST(std::abs(ratio - ratio_below) <= tolerance, name << ": " << ratio);
  }
}

// One of the steady motions above the border, which all have the same friction: it never slips
// back, and at the border comes to rest.
BOOST_AUTO_TEST_CASE(above_the_border_it_slides) {
  for (const Harmonic& harmonic : harmonics) {
    const System system = system_of(scene_of(harmonic.name));
    const double border = sliding_threshold(system).drive_velocity;
    for (const double velocity : {border, 1.01 * border, 1.1 * border, 2 * border}) {
      const SteadyState state = steady_state(system, velocity, Start::rest, 4000);
      BOOST_TEST((state.regime == Regime::sliding));
      BOOST_TEST(state.friction_ratio == 1);
      double least = velocity;
      for (const CyclePoint& point : state.cycle) least = std::min(least, point.contact_velocity);
      // Samples miss the slowest instant by up to 1e-3 rad, the velocity by that squared.
      BOOST_TEST(std::abs(least - (velocity - border)) <= 1e-5 * border);
      BOOST_TEST(energy_balance(system, velocity)->error <=
                 1e-12 * energy_balance(system, velocity)->drive);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_damper_or_another_stiffness_is_no_free_swing) {
  System system = system_of(scene_of("undamped_harmonic"));
  BOOST_TEST(free_harmonic(system) == 3);
  const double spring = system.drive->equilibrium;
  system.drive->equilibrium = std::nextafter(spring, 2 * spring);
  BOOST_TEST(free_harmonic(system) == 3);
  system.drive->equilibrium = spring * (1 + 1e-14);
  BOOST_TEST(free_harmonic(system) == 0);
  system.drive->equilibrium = spring;
  system.drive->damper = 1e-300;
  BOOST_TEST(free_harmonic(system) == 0);
}

// Decimals at a harmonic whose doubles are not, and springs in series whose stiffness rounds: what
// eval tells of, the motion does.
BOOST_AUTO_TEST_CASE(a_harmonic_but_for_rounding_is_one) {
  const auto check = [](const test::SceneText& text, int n) {
    const Scene scene = test::scene_of(text);
    const System system = system_of(scene);
    const CriticalOnset onset = critical_onset(scene);
    BOOST_TEST(onset.free_harmonics == std::vector{n});
    BOOST_TEST(free_harmonic(system) == n);
    const double border = onset.contact_velocity * std::cos(std::numbers::pi / (2 * n));
    BOOST_TEST(std::abs(onset.sliding_from / border - 1) <= 1e-15);
    // Both v* lose some roundings; no sum cancels.
    BOOST_TEST(std::abs(sliding_threshold(system).contact_velocity / border - 1) <= 1e-13);
    const SteadyState state = steady_state(system, 1.001 * border);
    BOOST_TEST((state.regime == Regime::sliding));
    BOOST_TEST(state.friction_ratio == 1);
  };
  test::SceneText text{.tangential = "kt", .network = "kd", .mass = 0.1, .angular_frequency = 1};
  text.elements = {{"kn", 3}, {"kt", 2}, {"kd", 0.9}};
  check(text, 3);
  text.network = "k1 - k2";
  for (const int k1 : {1, 3, 5, 7})
    for (const int k2 : {2, 3, 6, 9})
      for (const int n : {2, 3, 5}) {
        text.mass = static_cast<double>(k1 * k2) / ((k1 + k2) * n * n);
        text.elements = {{"kn", 3}, {"kt", 2}, {"k1", k1}, {"k2", k2}};
        check(text, n);
      }
}

// What friction falls short of mu0 by at most where a body on a spring swings nearly freely at
// harmonic n (proof: src/simulation/steady/full_friction.cpp), in SI units: with Z = (kd - m
// s^2)/s, s = n omega, missing force x and speed v between border and v*, (v - border) <x> <= v*
// sin(pi/(2 n))/n <|w|> |Z|, <|w|> <= v/(1 - D). The contact's own answer and the rounding of Z,
// some 1e-16, are left out: twice the bound is more than both.
double most_missing(const System& system, int n, double border, double critical, double share) {
  const double s = n * system.omega, mass = *system.mass;
  const double spring = system.drive->equilibrium, off = std::abs(spring - mass * s * s);
  const double v = border + share * (critical - border);
  const double relative = std::abs(system.normal_force_amplitude) / system.mean_normal_force;
  const double force = critical * std::sin(std::numbers::pi / (2 * n)) / n * v / (1 - relative) *
                       (off + 1e-15 * spring) / s / (v - border);
  return 2 * force / (system.friction * system.mean_normal_force);
}

// Between the border and v* of a drive that is next to its harmonic, by more than rounding: full
// friction but for the share by which it is off, or an error that says so and what to do; never
// another one.
BOOST_AUTO_TEST_CASE(nearly_at_a_harmonic_it_answers_or_says_why) {
  for (const Harmonic& harmonic : harmonics)
    for (const double off : {6e-15, -1e-14, 1e-12, -1e-11, 1e-10, 1e-9}) {
      System system = system_of(scene_of(harmonic.name));
      const double border = sliding_threshold(system).drive_velocity;
      system.drive->equilibrium *= 1 + off;
      const double critical = sliding_threshold(system).drive_velocity;
      for (const double share : {0.1, 0.5, 0.9}) {
        const SteadyState state =
            steady_state(system, border + share * (critical - border), Start::rest);
        BOOST_TEST(std::abs(1 - state.friction_ratio) <=
                   state.friction_ratio_error + 10 * std::abs(off));
        // Some rounding errors, or the share that sticks can take: see most_missing().
        BOOST_TEST(state.friction_ratio_error <=
                   1e-12 + most_missing(system, harmonic.n, border, critical, share));
      }
      SharedEffort none(0);
      system.effort = &none;
      const auto names_it = [&](const ModelError& error) {
        const std::string what = error.what();
        return what.find("harmonic " + std::to_string(harmonic.n)) != std::string::npos &&
               what.find("v* cos(pi/" + std::to_string(2 * harmonic.n)) != std::string::npos;
      };
      BOOST_CHECK_EXCEPTION(steady_state(system, 0.5 * (border + critical)), ModelError, names_it);
      BOOST_CHECK_EXCEPTION(steady_state(system, 0.5 * border), ModelError,
                            [&](const ModelError& error) { return !names_it(error); });
    }
}

// The last stick ends where no search tells, 1e-9 below v* and more: no comparison may fail by
// that.
BOOST_AUTO_TEST_CASE(a_faint_damper_leaves_sticks_that_die_slowly) {
  System system = system_of(scene_of("undamped_harmonic"));
  system.drive->damper = 1e-7 * system.drive->equilibrium / system.omega;
  BOOST_CHECK_THROW(stick_onset(system), ModelError);
  system.drive->damper = 0.1 * system.drive->equilibrium / system.omega;
  const double difference =
      stick_onset(system).contact_velocity / sliding_threshold(system).contact_velocity - 1;
  BOOST_TEST(std::abs(difference) <= 1e-9);
}

// However the loss comes about: within a share of 1e-5 no search tells; beyond it the last stick is
// where sliding begins by the balance of its harmonics, which no search has a part in.
BOOST_AUTO_TEST_CASE(a_faint_loss_of_any_network_is_known_by_what_it_takes) {
  const System undamped = system_of(scene_of("undamped_harmonic"));
  const double spring = undamped.drive->equilibrium, omega = undamped.omega;
  const double swing = 3 * omega;
  for (const double share : {1e-9, 1e-7, 9e-6, 3e-5, 1e-3}) {
    // With x = swing time: k1 (i x)/(1 + i x) loses k1 x/(1 + x^2) of which 1/2 at x = 1, while its
    // storage, half of it, is taken off the spring; a spring behind a damper of x >> 1 loses 1/x.
    const std::pair<const char*, Relaxation> drives[] = {
        {"damper", {spring, share * spring / swing, {}}},
        {"branch", {spring * (1 - share), 0, {{2 * share * spring, 1 / swing}}}},
        {"behind a damper", {0, 0, {{spring, 1 / (share * swing)}}}}};
    for (const auto& [name, drive] : drives) BOOST_TEST_CONTEXT(name << " " << share) {
        System system = undamped;
        system.drive = drive;
        BOOST_TEST(nearly_free_harmonic(system) == (share < 1e-5 ? 3 : 0));
        if (share < 1e-5) {
          BOOST_CHECK_THROW(stick_onset(system), ModelError);
        } else {
          const Onset stick = stick_onset(system), sliding = sliding_threshold(system);
          BOOST_TEST(std::abs(stick.drive_velocity / sliding.drive_velocity - 1) <=
                     1e-9 + stick.uncertainty / sliding.drive_velocity);
        }
      }
  }
}

// Of a drive with masses the distance of a pole is that of a frequency: half of its stiffness's.
BOOST_AUTO_TEST_CASE(a_drive_with_masses_is_as_near_a_harmonic_as_one_of_springs) {
  for (const double share : {-1.1e-5, -9e-6, 9e-6, 1.1e-5}) {
    const auto harmonic = [share](const char* drive, double mass) {
      return nearly_free_harmonic(
          system_of(test::scene_of({.tangential = "kt",
                                    .network = drive,
                                    .mass = mass,
                                    .angular_frequency = 1,
                                    .elements = {{"kn", 3}, {"kt", 2}, {"kd", 9 * (1 + share)}},
                                    .more = "ma = 0.25\n"})));
    };
    BOOST_TEST(harmonic("kd", 1) == (std::abs(share) < 1e-5 ? 3 : 0), share);
    BOOST_TEST(harmonic("kd | mass(ma)", 0.75) == harmonic("kd", 1), share);
  }
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()
