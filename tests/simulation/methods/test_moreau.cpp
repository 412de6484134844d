// Moreau-Jean time stepping: its order, the reference file, and stiff networks at any step.
#include "simulation/methods/methods.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "scene/scene.hpp"
#include "simulation/reference_systems.hpp"

BOOST_AUTO_TEST_SUITE(test_moreau)

namespace {

using namespace vcrit;
using namespace vcrit::simulation;

// Errors depend on where the events lie in the grid; the largest over several grids does not.
double largest_error(const reference::Row& row, int steps, double theta) {
  double largest = 0;
  for (int i = 0; i < 7; ++i) {
    MethodOptions options;
    options.steps_per_period = steps + i * steps / 13;
    options.theta = theta;
    const SteadyState state = steady_state(Method::moreau, row.system, row.velocity, options);
    largest = std::max(largest, std::abs(state.friction_ratio - row.friction_ratio));
  }
  return largest;
}

double order(const reference::Row& row, double theta) {
  return std::log2(largest_error(row, 200, theta) / largest_error(row, 3200, theta)) / 4;
}

}  // namespace

// Sixteen times as many steps: the error falls by 16^p, within a factor of 4 either way for the
// scatter that is left, that is p within 1/2.
BOOST_AUTO_TEST_CASE(order_of_convergence) {
  const std::vector<reference::Row> rows = reference::reference_rows();
  for (const std::size_t i : {3U, 6U, 12U, 18U, 27U, 33U, 39U}) BOOST_TEST_CONTEXT(rows[i].name) {
      BOOST_TEST(std::abs(order(rows[i], 0.5) - 2) < 0.5);
      BOOST_TEST(std::abs(order(rows[i], 1) - 1) < 0.5);
    }
}

// h = 2 pi/2000: h^2 = 1e-5 is the size of second-order errors in units of the oscillation. The
// estimate is of the same order with a larger factor; scatter over the grid may eat that up.
BOOST_AUTO_TEST_CASE(reference_values) {
  int covered = 0, rows = 0;
  for (const reference::Row& row : reference::reference_rows())
    for (const Start start : {Start::sliding, Start::rest}) BOOST_TEST_CONTEXT(row.name) {
        MethodOptions options;
        options.start = start;
        const SteadyState state = steady_state(Method::moreau, row.system, row.velocity, options);
        const double error = std::abs(state.friction_ratio - row.friction_ratio);
        BOOST_TEST(error < 1e-5);
        BOOST_TEST(state.friction_ratio_error < 1e-3);
        BOOST_TEST(state.events.size() == row.events);
        BOOST_TEST((state.regime == Regime::stick_slip));
        covered += error <= state.friction_ratio_error;
        ++rows;
      }
  BOOST_TEST(covered >= 0.95 * rows);
}

// Others take some 1000 plain periods each.
bool soon_settled(const System& system) {
  const Relaxation& contact = system.contact;
  return contact.damper <= 10 && (contact.branches.empty() || contact.branches[0].time <= 10);
}

// A stick shorter than a step, or one that the step's own error of the swing takes away near a
// resonance. True ratios: a program of 50 digits. What is said to be sliding may hide it.
BOOST_AUTO_TEST_CASE(sticks_that_steps_may_miss) {
  struct Near {
    const char* scene;
    double velocity, ratio;
  };
  for (const auto& [name, velocity, ratio] :
       {Near{"resonance-1011", 0.09936183992030705, 0.9977974173327},
        Near{"resonance-1016", 0.02514784407989958, 0.9999436133535}}) {
    const System system =
        system_of(read_scene(std::string(VCRIT_TEST_DATA "/near_onset/") + name + ".toml"));
    const SteadyState state = steady_state(Method::moreau, system, velocity, {});
    BOOST_TEST(std::abs(state.friction_ratio - ratio) <= state.friction_ratio_error, name);
  }
}

// Well above v* there is nothing to miss.
BOOST_AUTO_TEST_CASE(sliding_is_certain_away_from_the_onset) {
  for (const reference::Row& row : reference::reference_rows())
    for (const bool newton : {true, false}) {
      if (!newton && !soon_settled(row.system)) continue;
      MethodOptions options;
      options.newton = newton;
      const SteadyState state =
          steady_state(Method::moreau, row.system, 1.2 * row.threshold, options);
      BOOST_TEST((state.regime == Regime::sliding), row.name);
      BOOST_TEST(state.friction_ratio_error <= 1e-9, row.name);
    }
}

// Without a damper, a law imposed in the middle of each step would make F ring about the bound, and
// show an event every other step.
BOOST_AUTO_TEST_CASE(events_do_not_ring_in_coarse_steps) {
  for (const reference::Row& row : reference::reference_rows())
    for (const int steps : {100, 300}) {
      MethodOptions options;
      options.steps_per_period = steps;
      const SteadyState state = steady_state(Method::moreau, row.system, row.velocity, options);
      BOOST_TEST(state.events.size() <= row.events, row.name << " in " << steps << " steps");
    }
}

// Newton only finds sooner what plain periods go to.
BOOST_AUTO_TEST_CASE(plain_periods_end_at_the_same_cycle) {
  for (const reference::Row& row : reference::reference_rows()) {
    if (!soon_settled(row.system)) continue;
    MethodOptions options;
    options.steps_per_period = 400;
    const SteadyState direct = steady_state(Method::moreau, row.system, row.velocity, options);
    options.newton = false;
    const SteadyState plain = steady_state(Method::moreau, row.system, row.velocity, options);
    BOOST_TEST(std::abs(plain.friction_ratio - direct.friction_ratio) <=
               plain.friction_ratio_error);
  }
}

BOOST_AUTO_TEST_SUITE_END()
