// GSL's adaptive integrators with located events: the reference file, grazing, slow and stiff
// relaxation, and how they give up.
#include "simulation/methods/methods.hpp"

#include <gsl/gsl_errno.h>

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "base/errors.hpp"
#include "simulation/reference_systems.hpp"

BOOST_AUTO_TEST_SUITE(test_switching)

namespace {

using namespace vcrit;
using namespace vcrit::simulation;

// P3 with tau <= 1e-6 periods holds an explicit method back to steps of that size.
bool stiff(const System& system) {
  return !system.contact.branches.empty() && system.contact.branches[0].time < 1e-4;
}

std::string failure(Method method, const System& system, double velocity,
                    const MethodOptions& options) {
  try {
    steady_state(method, system, velocity, options);
  } catch (const ModelError& error) {
    return error.what();
  }
  return "";
}

bool contains(const std::string& text, const char* part) { return text.find(part) != text.npos; }

System elastic(double amplitude) {
  System system;
  system.contact = {1, 0, {}};
  system.omega = 1;
  system.friction = 0.5;
  system.mean_normal_force = 2;
  system.normal_force_amplitude = 2 * amplitude;
  return system;
}

struct Promise {
  Method method;
  double tolerance, error;
};

// Errors a step add up over some 100 steps a period and are amplified like those of any cycle, at
// most 16 x 220 times (P1 with c = 100: it keeps exp(-2 pi/100) of them a period, and its velocity
// is 0.0045 of the unit) but a few times elsewhere. GSL's msbdf errs by some 30 tolerances a step.
constexpr Promise promises[] = {{Method::rk8pd, 1e-10, 1e-8},
                                {Method::rk8pd, 1e-13, 1e-11},
                                {Method::rkf45, 1e-10, 1e-8},
                                {Method::msbdf, 1e-10, 1e-6}};

}  // namespace

BOOST_AUTO_TEST_CASE(reference_values) {
  for (const auto& [method, tolerance, promised] : promises) {
    int covered = 0, rows = 0;
    for (const reference::Row& row : reference::reference_rows()) {
      if (method != Method::msbdf && stiff(row.system)) continue;
      BOOST_TEST_CONTEXT(to_text(method) << " " << row.name) {
        MethodOptions options;
        options.tolerance = tolerance;
        const SteadyState state = steady_state(method, row.system, row.velocity, options);
        const double error = std::abs(state.friction_ratio - row.friction_ratio);
        BOOST_TEST(error <= promised);
        BOOST_TEST(state.events.size() == row.events);
        BOOST_TEST((state.regime == Regime::stick_slip));
        BOOST_TEST(state.periods.value_or(0) == 1);
        covered += error <= state.friction_ratio_error;
        ++rows;
      }
    }
    BOOST_TEST(covered >= 0.95 * rows, to_text(method) << ": " << covered << " of " << rows);
  }
}

BOOST_AUTO_TEST_CASE(rest_ends_where_sliding_does) {
  for (const reference::Row& row : reference::reference_rows()) {
    if (stiff(row.system)) continue;
    MethodOptions options;
    options.start = Start::rest;
    const SteadyState state = steady_state(Method::rk8pd, row.system, row.velocity, options);
    BOOST_TEST(std::abs(state.friction_ratio - row.friction_ratio) <= 1e-8, row.name);
  }
}

// v0 = v* (1 - eps): 1 - mu/mu0 -> D 9/(4 pi) eps^2, stick lasts sqrt(18 eps), both with
// corrections of relative order eps. Sticks of 1e-4 of a period, far shorter than a step, are
// found; w is an explicit function of time here, so no tolerance hides it.
BOOST_AUTO_TEST_CASE(short_sticks_are_not_missed) {
  const double pi = std::acos(-1.0);
  for (const Method method : {Method::rkf45, Method::rk8pd, Method::msbdf})
    for (const double eps : {1e-4, 1e-6, 1e-8}) {
      const SteadyState state = steady_state(method, elastic(0.9), 0.9 * (1 - eps));
      BOOST_TEST_REQUIRE(state.events.size() == 2U, to_text(method) << " at " << eps);
      const double length = std::abs(state.events[0].phase - state.events[1].phase);
      BOOST_TEST(std::abs(length / std::sqrt(18 * eps) - 1) < 10 * eps + 1e-3);
      const double lost = 0.9 * 9 / (4 * pi) * eps * eps;
      BOOST_TEST(std::abs(1 - state.friction_ratio - lost) <= 10 * eps * lost + 1e-9);
    }
}

// A loose tolerance costs digits, not the effect: Newton takes sliding to its own steady state
// before it is called that.
BOOST_AUTO_TEST_CASE(loose_tolerances_do_not_hide_sticks) {
  for (const reference::Row& row : reference::reference_rows()) {
    if (stiff(row.system)) continue;
    MethodOptions options;
    options.tolerance = 1e-4;
    for (const Method method : {Method::rkf45, Method::rk8pd})
      BOOST_TEST(!steady_state(method, row.system, row.velocity, options).events.empty(), row.name);
  }
}

BOOST_AUTO_TEST_CASE(slides_above_the_critical_velocity) {
  for (const reference::Row& row : reference::reference_rows()) {
    if (stiff(row.system)) continue;
    const SteadyState state = steady_state(Method::rk8pd, row.system, 1.0001 * row.threshold);
    BOOST_TEST(state.friction_ratio == 1.0, row.name);
    BOOST_TEST((state.regime == Regime::sliding));
  }
}

// Stuck, the body swings on k + k_d = 2 at 4.5 omega and throws the contact backwards; the value is
// that of another method, implicit time stepping with its own error.
BOOST_AUTO_TEST_CASE(backward_slip) {
  System system = elastic(0.97);
  system.drive = Relaxation{1, 0.05, {}};
  system.mass = 0.1;
  for (const double velocity : {0.51, 0.61}) {
    MethodOptions options;
    options.steps_per_period = 8000;
    const SteadyState stepped = steady_state(Method::moreau, system, velocity, options);
    BOOST_TEST((stepped.regime == Regime::stick_slip_backslip));
    for (const Method method : {Method::rkf45, Method::rk8pd, Method::msbdf}) {
      const SteadyState state = steady_state(method, system, velocity, options);
      BOOST_TEST((state.regime == Regime::stick_slip_backslip));
      BOOST_TEST(state.events.size() == stepped.events.size());
      BOOST_TEST(std::abs(state.friction_ratio - stepped.friction_ratio) <=
                 state.friction_ratio_error + stepped.friction_ratio_error);
    }
  }
}

// With c = 100 the contact slides for its first 30 periods and more before it ever sticks: friction
// is 1 all the while, but the state is not at rest.
BOOST_AUTO_TEST_CASE(sliding_that_will_end_is_not_taken_for_steady) {
  for (const reference::Row& row : reference::reference_rows()) {
    if (row.system.contact.damper < 10) continue;
    MethodOptions options;
    options.newton = false;
    const SteadyState state = steady_state(Method::rk8pd, row.system, row.velocity, options);
    BOOST_TEST(std::abs(state.friction_ratio - row.friction_ratio) <= state.friction_ratio_error,
               row.name);
    BOOST_TEST(state.friction_ratio_error < 1e-6);
  }
}

// A drive without damping: what swings in slip swings for ever; only Newton's method ends.
BOOST_AUTO_TEST_CASE(undamped_drives_need_newton) {
  System system = elastic(0.9);
  system.drive = Relaxation{2, 0, {}};
  system.mass = 0.3;
  MethodOptions options;
  options.most_periods = 300;
  const SteadyState state = steady_state(Method::rk8pd, system, 2, options);
  BOOST_TEST(state.friction_ratio == 1.0);
  options.newton = false;
  BOOST_TEST(contains(failure(Method::rk8pd, system, 2, options), "not settled after 300 periods"));
}

// Without Newton, relaxation over 1000 periods looks like rest long before it is over: the answer
// is refused, or its error says so.
BOOST_AUTO_TEST_CASE(slow_relaxation_is_not_taken_for_rest) {
  for (const reference::Row& row : reference::reference_rows()) {
    if (row.system.contact.branches.empty() || row.system.contact.branches[0].time < 1e3) continue;
    MethodOptions options;
    options.newton = false;
    options.most_periods = 1000;
    try {
      const SteadyState state = steady_state(Method::rk8pd, row.system, row.velocity, options);
      BOOST_TEST(std::abs(state.friction_ratio - row.friction_ratio) <= state.friction_ratio_error,
                 row.name);
    } catch (const ModelError& error) {
      BOOST_TEST(contains(error.what(), "by its trend"));
    }
  }
}

BOOST_AUTO_TEST_CASE(explicit_methods_say_that_a_system_is_stiff) {
  for (const reference::Row& row : reference::reference_rows()) {
    if (!stiff(row.system)) continue;
    MethodOptions options;
    options.most_steps = 20'000;
    for (const Method method : {Method::rkf45, Method::rk8pd})
      BOOST_TEST(contains(failure(method, row.system, row.velocity, options),
                          "has not settled after 20000 steps, the last of"));
  }
}

namespace {

void handler_of_the_host(const char*, const char*, int, int) {}

}  // namespace

BOOST_AUTO_TEST_CASE(the_error_handler_of_the_host_stays) {
  gsl_error_handler_t* const before = gsl_set_error_handler(handler_of_the_host);
  steady_state(Method::rk8pd, elastic(0.9), 0.5);
  BOOST_TEST((gsl_set_error_handler(before) == handler_of_the_host));
}

BOOST_AUTO_TEST_SUITE_END()
