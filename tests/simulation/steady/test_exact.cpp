// Steady states against independent values: high-precision references, the closed form of the
// elastic contact, and properties that hold for every system.
#include "simulation/steady/exact.hpp"
#include "simulation/steady/onset.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>

#include "base/errors.hpp"
#include "simulation/methods/methods.hpp"
#include "simulation/random_systems.hpp"
#include "simulation/reference_systems.hpp"
#include "simulation/steady/curve.hpp"
#include "simulation/steady/energy.hpp"

BOOST_AUTO_TEST_SUITE(test_exact)

namespace {

using namespace vcrit;
using namespace vcrit::simulation;

constexpr double u = 1.1e-16;

std::vector<Start> both_starts() { return {Start::sliding, Start::rest}; }

// A state is known to some 10 u; the friction ratio is its mean over a period, and the most that
// the systems below amplify an error of the state is the 1/(1 - multiplier) of P1 with delta = 100,
// which loses exp(-2 pi/100) a period: 16 times, on velocities that are 1/0.0045 of the unit: 16 x
// 220 x 10 u = 4e-12. The others stay below 1e3 u.
double reference_tolerance(const System& system) {
  return system.contact.damper >= 10 ? 4e-12 : 1000 * u;
}

Relaxation spring(double k) { return {k, 0, {}}; }

// k = 1, mu0 <F_n> = 1, v* = D.
System elastic(double d) {
  System system;
  system.contact = spring(1);
  system.omega = 1;
  system.friction = 0.5;
  system.mean_normal_force = 2;
  system.normal_force_amplitude = 2 * d;
  return system;
}

}  // namespace

BOOST_AUTO_TEST_CASE(reference_values_from_both_starts) {
  double worst = 0;
  for (const reference::Row& row : reference::reference_rows())
    for (const Start start : both_starts()) {
      BOOST_TEST_CONTEXT(row.name) {
        const SteadyState state = steady_state(row.system, row.velocity, start);
        const double error = std::abs(state.friction_ratio - row.friction_ratio);
        BOOST_TEST(error <= reference_tolerance(row.system));
        BOOST_TEST(error <= state.friction_ratio_error + u);
        BOOST_TEST(state.friction_ratio_error < 1e-12);
        BOOST_TEST(state.events.size() == row.events);
        BOOST_TEST(state.periods.value_or(0) == 1);
        worst = std::max(worst, error);
      }
    }
  BOOST_TEST_MESSAGE("largest error " << worst);
}

// Closed form of the elastic contact: mu_macro/mu0 = 1 - D G(v0/v*), values of G to 20 digits.
constexpr double elastic_values[][2] = {
    {0.001, 0.99693266303416232517},   {0.1, 0.75717136015312994339},
    {0.25, 0.4918816026829403061},     {0.5, 0.2014522033336686888},
    {0.75, 0.047238266278833194827},   {0.9, 0.0073108103345282100357},
    {0.99, 0.000071763498506863749421}};

BOOST_AUTO_TEST_CASE(elastic_closed_form) {
  for (const double d : {0.1, 0.9, 0.999})
    for (const auto& [ratio, g] : elastic_values)
      for (const Start start : both_starts()) {
        const SteadyState state = steady_state(elastic(d), ratio * d, start);
        // One stick, a handful of operations on numbers of order 1 each, phases up to 2 pi.
        BOOST_TEST(std::abs(state.friction_ratio - (1 - d * g)) <= 40 * u);
        BOOST_TEST(state.events.size() == 2U);
      }
}

// A unit that relaxes within a rounding error of the period is a spring more: k = 1 again. Its
// rounding error as stick begins is far above what decides there between stick and slip.
BOOST_AUTO_TEST_CASE(fast_units_of_an_elastic_contact) {
  for (const double time : {1e-17, 1e-19, 1e-21, 1e-25})
    for (const double branch : {0.01, 0.055, 1.0, 20.0})
      for (const double d : {0.1, 0.45832, 0.999})
        for (const auto& [ratio, g] : elastic_values)
          for (const Start start : both_starts()) {
            System system = elastic(d);
            system.contact = {1, 0, {{branch, time}}};
            const SteadyState state = steady_state(system, ratio * d, start);
            BOOST_TEST_CONTEXT("time " << time << ", branch " << branch << ", D " << d << ", at "
                                       << ratio << " v*") {
              // As above, with rates up to 1 + branch times as large before the branch has relaxed.
              BOOST_TEST(std::abs(state.friction_ratio - (1 - d * g)) <= 40 * u * (1 + branch));
              BOOST_TEST(std::abs(state.friction_ratio - (1 - d * g)) <=
                         state.friction_ratio_error + 10 * u);
              BOOST_TEST(state.events.size() == 2U);
            }
          }
}

// So is a body that swings and rests within a touch of each event, between contact and drive: the
// springs in series. What the drive's damper does to an elastic path is of the order of its share.
BOOST_AUTO_TEST_CASE(light_bodies_between_elastic_paths) {
  for (const double mass : {1e-28, 1e-24, 1e-22})
    for (const double share : {1e-14, 1e-12})
      for (const double stiffness : {0.1, 100.0})
        for (const double branch : {0.0, 0.07, 3.0})
          for (const auto& [ratio, g] : elastic_values)
            for (const Start start : both_starts()) {
              System system = elastic(0.45832);
              if (branch > 0) system.contact = {1, 0, {{branch, 1e-11}}};
              system.drive = Relaxation{stiffness, share * stiffness, {}};
              system.mass = mass;
              const double path = 1 / (1 + 1 / stiffness), velocity = ratio * 0.45832 / path;
              const SteadyState state = steady_state(system, velocity, start);
              const double error = std::abs(state.friction_ratio - (1 - 0.45832 * g));
              BOOST_TEST_CONTEXT("mass " << mass << ", damper " << share << ", drive " << stiffness
                                         << ", branch " << branch << ", at " << ratio << " v*") {
                // Whatever it states: rounding as above, and what damper and branch may change.
                BOOST_TEST(error <= 40 * u * (1 + branch) + 10 * (share + 1e-11 * branch));
              }
            }
}

// v0 = v* (1 - eps): G -> 9/(4 pi) eps^2, and the stick's length is sqrt(18 eps) to leading order
// (both from the expansion of the closed form at its end); corrections are of relative order eps.
BOOST_AUTO_TEST_CASE(grazing) {
  for (const double eps : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
    const SteadyState state = steady_state(elastic(0.9), 0.9 * (1 - eps));
    BOOST_TEST_REQUIRE(state.events.size() == 2U);
    const bool slip_first = state.events[0].to == Motion::slip;
    double length = state.events[slip_first ? 0 : 1].phase - state.events[slip_first ? 1 : 0].phase;
    if (length < 0) length += 2 * std::numbers::pi;
    // 0.9 (1 - eps) is rounded, which moves eps by u/eps of itself; phases are known to 10 u.
    const double relative = 2 * eps + 2 * u / eps + 10 * u / std::sqrt(eps);
    BOOST_TEST(std::abs(length / std::sqrt(18 * eps) - 1) <= relative);
    const double lost = 0.9 * 9 / (4 * std::numbers::pi) * eps * eps;
    BOOST_TEST(std::abs(1 - state.friction_ratio - lost) <= 4 * eps * lost + 10 * u);
  }
}

BOOST_AUTO_TEST_CASE(thresholds_of_the_reference) {
  for (const reference::Row& row : reference::reference_rows()) {
    const Onset threshold = sliding_threshold(row.system);
    // Near the body's resonance |K_d - m w^2| cancels by up to 0.5/0.2, else some 10 operations.
    BOOST_TEST(std::abs(threshold.contact_velocity / row.threshold - 1) <= 40 * u, row.name);
    BOOST_TEST(threshold.drive_velocity == threshold.contact_velocity);
    BOOST_TEST(steady_state(row.system, row.threshold * (1 + 100 * u)).friction_ratio == 1.0);
    BOOST_TEST(steady_state(row.system, row.threshold * 1.5, Start::rest).events.empty());
  }
}

// Friction is single-valued (Coulomb friction is maximal monotone): the two starts agree within
// what both say of themselves. Every system ends in a cycle of one period.
BOOST_AUTO_TEST_CASE(rest_and_sliding_starts_agree) {
  constexpr unsigned seed = 4711;
  BOOST_TEST_MESSAGE("seed " << seed);
  for (unsigned i = 0; i < 600; ++i) {
    reference::RandomSystems systems(seed + i, i % 3 == 0 ? 1 : (i % 3 == 1 ? 4 : 9));
    const System system = systems.system();
    const double velocity = sliding_threshold(system).drive_velocity * systems.logarithmic(0.02, 1);
    const SteadyState slid = steady_state(system, velocity, Start::sliding);
    const SteadyState rested = steady_state(system, velocity, Start::rest);
    BOOST_TEST_CONTEXT("system " << i) {
      const double difference = std::abs(slid.friction_ratio - rested.friction_ratio);
      BOOST_TEST(difference <= slid.friction_ratio_error + rested.friction_ratio_error);
      BOOST_TEST(slid.friction_ratio_error < 1e-7);
      BOOST_TEST(slid.periods.has_value());
      BOOST_TEST(slid.events.size() == rested.events.size());
      BOOST_TEST(slid.friction_ratio <= 1 + slid.friction_ratio_error);
    }
  }
}

// All stiffnesses, dampers, masses and forces times one number: the same motion. With a power of
// two every operation is the same but for its exponent.
BOOST_AUTO_TEST_CASE(scaling_leaves_the_ratio_alone) {
  for (unsigned i = 0; i < 50; ++i) {
    reference::RandomSystems systems(99 + i, 3);
    const System system = systems.system();
    System large = system;
    large.contact = scaled(system.contact, 1024);
    if (system.drive) large.drive = scaled(*system.drive, 1024);
    if (system.mass) large.mass = 1024 * *system.mass;
    large.mean_normal_force *= 1024;
    large.normal_force_amplitude *= 1024;
    const double velocity = 0.3 * sliding_threshold(system).drive_velocity;
    BOOST_TEST(sliding_threshold(large).drive_velocity == sliding_threshold(system).drive_velocity);
    BOOST_TEST(steady_state(large, velocity).friction_ratio ==
               steady_state(system, velocity).friction_ratio);
  }
}

// Another unit of time: omega, rates and velocities times 4, dampers and masses divided by 4
// and 16. (A power of 4: roots are bracketed by means of square roots.)
BOOST_AUTO_TEST_CASE(unit_of_time_leaves_the_ratio_alone) {
  for (unsigned i = 0; i < 50; ++i) {
    reference::RandomSystems systems(199 + i, 3);
    const System system = systems.system();
    System fast = system;
    fast.omega *= 4;
    const auto quicken = [](Relaxation& form) {
      form.damper /= 4;
      for (MaxwellBranch& branch : form.branches) branch.time /= 4;
    };
    quicken(fast.contact);
    if (fast.drive) quicken(*fast.drive);
    if (fast.mass) *fast.mass /= 16;
    const double velocity = 0.3 * sliding_threshold(system).drive_velocity;
    BOOST_TEST(steady_state(fast, 4 * velocity).friction_ratio ==
               steady_state(system, velocity).friction_ratio);
  }
}

namespace {

// Neither contact nor drive loses energy: what swings in slip or stick swings for ever.
System undamped(double contact, double drive, double mass, double amplitude) {
  System system = elastic(amplitude);
  system.contact = spring(contact);
  system.drive = spring(drive);
  system.mass = mass;
  return system;
}

}  // namespace

BOOST_AUTO_TEST_CASE(undamped_drives_reach_their_steady_state) {
  constexpr unsigned seed = 5;
  BOOST_TEST_MESSAGE("seed " << seed);
  reference::RandomSystems random(seed, 1);
  for (int i = 0; i < 100; ++i) {
    const System system = undamped(random.logarithmic(0.1, 10), random.logarithmic(0.1, 10),
                                   random.logarithmic(0.1, 10), random.uniform(0.05, 0.99));
    const double v = sliding_threshold(system).drive_velocity;
    const double below = v * random.logarithmic(0.02, 1);
    const SteadyState slid = steady_state(system, below, Start::sliding);
    const SteadyState rested = steady_state(system, below, Start::rest);
    BOOST_TEST_CONTEXT("system " << i) {
      BOOST_TEST(std::abs(slid.friction_ratio - rested.friction_ratio) <=
                 slid.friction_ratio_error + rested.friction_ratio_error);
      BOOST_TEST(slid.friction_ratio_error < 1e-9);
      // A little above v* 20,000 cycles would leave 1e-9 of the transient; the value is at hand.
      BOOST_TEST(steady_state(system, 1.05 * v, Start::rest).friction_ratio == 1.0);
    }
  }
}

BOOST_AUTO_TEST_CASE(resonance_and_antiresonance) {
  // K_d = m w^2: v* is infinite, and friction reduced at any speed.
  const System resonant = undamped(1, 2, 2, 0.5);
  BOOST_TEST(std::isinf(sliding_threshold(resonant).contact_velocity));
  for (const double velocity : {0.1, 10.0})
    BOOST_TEST(steady_state(resonant, velocity).friction_ratio < 0.9);
  // K_t + K_d = m w^2: v* = 0, friction is not reduced at any speed.
  const System antiresonant = undamped(1, 1, 2, 0.5);
  BOOST_TEST(sliding_threshold(antiresonant).contact_velocity == 0.0);
  BOOST_TEST(steady_state(antiresonant, 1e-6, Start::rest).friction_ratio == 1.0);
}

// The sampled cycle keeps Coulomb's law, and its mean force is the friction ratio.
BOOST_AUTO_TEST_CASE(sampled_cycles_keep_the_law_of_friction) {
  for (unsigned i = 0; i < 40; ++i) {
    reference::RandomSystems systems(2000 + i, 1);
    const System system = systems.system();
    const double velocity = 0.5 * sliding_threshold(system).drive_velocity;
    constexpr int samples = 20000;
    const SteadyState state = steady_state(system, velocity, Start::sliding, samples);
    const double unit = system.friction * system.mean_normal_force;
    double sum = 0;
    for (const CyclePoint& point : state.cycle) {
      BOOST_TEST_REQUIRE(std::abs(point.force) <= point.friction_bound + 1e-13 * unit);
      const double law = point.contact_velocity > 0 ? point.friction_bound : -point.friction_bound;
      if (point.contact_velocity != 0)
        BOOST_TEST_REQUIRE(std::abs(point.force - law) <= 1e-13 * unit);
      sum += point.force / unit;
    }
    // The force is continuous, its slope may jump: the trapezoidal rule errs by (2 pi/n)^2/12 times
    // the slope's total change in a period, itself below 100 here.
    BOOST_TEST(std::abs(sum / samples - state.friction_ratio) <= 100 * 1e-8);
  }
}

// Stick follows slip of either direction and the other way round; phases lie within one turn.
BOOST_AUTO_TEST_CASE(events_take_turns) {
  for (unsigned i = 0; i < 60; ++i) {
    reference::RandomSystems systems(3000 + i, 3);
    const System system = systems.system();
    const SteadyState state =
        steady_state(system, 0.2 * sliding_threshold(system).drive_velocity, Start::rest);
    BOOST_TEST(state.events.size() % 2 == 0U);
    for (std::size_t j = 0; j < state.events.size(); ++j) {
      const Event &event = state.events[j], &next = state.events[(j + 1) % state.events.size()];
      BOOST_TEST((event.phase >= 0 && event.phase < 2 * std::numbers::pi));
      BOOST_TEST(((event.to == Motion::stick) != (next.to == Motion::stick)));
    }
  }
}

BOOST_AUTO_TEST_CASE(speeds_that_are_none_are_wrong_input) {
  const System system = elastic(1);
  for (const double speed : {0.0, -1.0, HUGE_VAL, std::nan("")}) {
    BOOST_CHECK_THROW(steady_state(system, speed), InputError);
    BOOST_CHECK_THROW(steady_state(Method::moreau, system, speed, {}), InputError);
    BOOST_CHECK_THROW(energy_balance(system, speed), InputError);
    BOOST_CHECK_THROW(friction_curve(system, std::array{0.5, speed}), InputError);
  }
}

BOOST_AUTO_TEST_SUITE_END()
