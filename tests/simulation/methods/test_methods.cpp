// All methods together: names and options, agreement with the exact one over random systems, and
// systems at the edge of what there is.
#include "simulation/methods/methods.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "base/errors.hpp"
#include "simulation/random_systems.hpp"
#include "simulation/steady/exact.hpp"
#include "simulation/steady/onset.hpp"

BOOST_AUTO_TEST_SUITE(test_methods)

namespace {

using namespace vcrit;
using namespace vcrit::simulation;

constexpr Method integrating[] = {Method::moreau, Method::rkf45, Method::rk8pd, Method::msbdf,
                                  Method::tanh};

System of_contact(const Relaxation& contact) {
  System system;
  system.contact = contact;
  system.omega = 1;
  system.friction = 0.5;
  system.mean_normal_force = 2;
  system.normal_force_amplitude = {0, 1.6};
  return system;
}

}  // namespace

BOOST_AUTO_TEST_CASE(names_come_back) {
  for (const Method method : all_methods()) BOOST_TEST((method_named(to_text(method)) == method));
  BOOST_TEST(!method_named("exact").has_value());
  BOOST_TEST(!method_named("").has_value());
}

BOOST_AUTO_TEST_CASE(options_out_of_range_are_refused) {
  const auto refused = [](auto change, Method method = Method::rk8pd) {
    MethodOptions options;
    change(options);
    BOOST_CHECK_THROW(steady_state(method, of_contact({1, 0, {}}), 0.1, options), InputError);
  };
  refused([](MethodOptions& o) { o.tolerance = 0; });
  refused([](MethodOptions& o) { o.tolerance = 2e-3; });
  refused([](MethodOptions& o) { o.tolerance = std::nan(""); });
  refused([](MethodOptions& o) { o.steps_per_period = 3; });
  refused([](MethodOptions& o) { o.steps_per_period = 10'000'001; });
  refused([](MethodOptions& o) { o.theta = 0.4; });
  refused([](MethodOptions& o) { o.regularisation = -1; });
  refused([](MethodOptions& o) { o.regularisation = 1e-300; });
  refused([](MethodOptions& o) { o.regularisation = 1.1; });
  refused([](MethodOptions& o) { o.tolerance = 2e-4; }, Method::tanh);
}

// The estimates are of errors that scatter; nine in ten hold, and those that do not are within a
// factor of 20.
BOOST_AUTO_TEST_CASE(agree_with_the_exact_method_on_random_systems) {
  constexpr unsigned seed = 7000;
  constexpr int systems = 60;
  BOOST_TEST_MESSAGE("seed " << seed);
  for (const Method method : integrating) {
    int covered = 0;
    for (unsigned i = 0; i < systems; ++i) {
      reference::RandomSystems random(seed + i, 1);
      const System system = random.system();
      const double velocity =
          sliding_threshold(system).drive_velocity * random.logarithmic(0.03, 1.2);
      MethodOptions options;
      options.tolerance = method == Method::tanh ? 1e-7 : 1e-10;
      BOOST_TEST_CONTEXT(to_text(method) << ", system " << i) {
        const SteadyState exact = steady_state(system, velocity);
        const SteadyState state = steady_state(method, system, velocity, options);
        const double error = std::abs(state.friction_ratio - exact.friction_ratio);
        const double estimate = state.friction_ratio_error + exact.friction_ratio_error;
        BOOST_TEST(error <= 20 * estimate);
        BOOST_TEST(error <= 2e-3);
        covered += error <= estimate;
      }
    }
    BOOST_TEST(covered >= 0.9 * systems, to_text(method) << ": " << covered);
  }
}

// The roughest settings that are taken state an error that holds as often as the finer ones' does.
BOOST_AUTO_TEST_CASE(the_roughest_settings_know_their_error) {
  constexpr unsigned seed = 7100;
  constexpr int systems = 60;
  BOOST_TEST_MESSAGE("seed " << seed);
  for (const Method method : integrating)
    for (const double width : {1e-2, 1.0}) {
      int covered = 0;
      for (unsigned i = 0; i < systems; ++i) {
        reference::RandomSystems random(seed + i, 1);
        const System system = random.system();
        const double velocity =
            sliding_threshold(system).drive_velocity * random.logarithmic(0.03, 0.97);
        MethodOptions options;
        options.tolerance = 1e-3;
        options.regularisation = width;
        options.steps_per_period = 20;
        const double exact = steady_state(system, velocity).friction_ratio;
        try {
          const SteadyState state = steady_state(method, system, velocity, options);
          covered += std::abs(state.friction_ratio - exact) <= state.friction_ratio_error;
        } catch (const ModelError&) {
          ++covered;  // gives no number
        }
      }
      BOOST_TEST(covered >= 0.85 * systems, to_text(method) << ", " << width << ": " << covered);
    }
}

// F = min(eta v0, b) at each moment, as nothing is stored: no state at all.
BOOST_AUTO_TEST_CASE(a_damper_alone) {
  const double eta = 0.7, force = 1;
  // <min(f, 1 + 0.8 cos t)> with the bound below f for |t - pi| < a, cos a = (1 - f)/0.8.
  const double pi = std::acos(-1.0), a = std::acos((1 - force) / 0.8);
  const double mean = (force * (pi - a) + a - 0.8 * std::sin(a)) / pi;
  for (const Method method : integrating) {
    const SteadyState state = steady_state(method, of_contact({0, eta, {}}), force / eta);
    // Of order h^2, w_reg/v0 or tolerance.
    BOOST_TEST(std::abs(state.friction_ratio - mean) < 2e-3, to_text(method));
    BOOST_TEST(std::abs(state.friction_ratio - mean) <= state.friction_ratio_error + 1e-14,
               to_text(method));
  }
}

// Below mu0 min F_n/eta a path that creeps never slips: mu_macro/mu0 = eta v0/(mu0 <F_n>).
BOOST_AUTO_TEST_CASE(a_path_that_creeps_sticks_for_ever) {
  for (const Method method : integrating)
    for (const Start start : {Start::sliding, Start::rest}) {
      MethodOptions options;
      options.start = start;
      const SteadyState state =
          steady_state(method, of_contact({0, 0, {{2, 1.5}}}), 0.1 / 3, options);
      BOOST_TEST((state.regime == Regime::stick), to_text(method));
      // With tanh the contact point creeps with some 0.1 w_reg; msbdf errs by some 30 tolerances a
      // step.
      const double allowed = method == Method::tanh ? 1e-4 : method == Method::msbdf ? 1e-7 : 1e-9;
      BOOST_TEST(std::abs(state.friction_ratio - 0.1) < allowed, to_text(method));
    }
}

// No mass: contact and drive are one network, here two springs in series, half as stiff as one.
BOOST_AUTO_TEST_CASE(a_body_without_mass_passes_the_force_on) {
  System both = of_contact({2, 0, {}});
  both.drive = Relaxation{2, 0, {}};
  for (const Method method : integrating)
    BOOST_TEST(std::abs(steady_state(method, both, 0.4).friction_ratio -
                        steady_state(method, of_contact({1, 0, {}}), 0.4).friction_ratio) < 1e-12,
               to_text(method));
}

// Another unit of force or of time changes nothing but the last digits.
BOOST_AUTO_TEST_CASE(units_do_not_matter) {
  System system = of_contact({1, 0.3, {{2, 1}}});
  system.drive = Relaxation{2, 0.1, {}};
  system.mass = 0.5;
  System other = system;
  const auto change = [](Relaxation& form) {
    form = scaled(form, 1e6);
    form.damper *= 1e-5;
    for (MaxwellBranch& branch : form.branches) branch.time *= 1e-5;
  };
  change(other.contact);
  change(*other.drive);
  *other.mass *= 1e6 * 1e-10;
  other.omega *= 1e5;
  other.mean_normal_force *= 1e3;
  other.normal_force_amplitude *= 1e3;
  for (const Method method : integrating) {
    const SteadyState a = steady_state(method, system, 0.3);
    const SteadyState b = steady_state(method, other, 0.3 * 1e-3 * 1e5);
    BOOST_TEST(std::abs(a.friction_ratio - b.friction_ratio) <=
                   a.friction_ratio_error + b.friction_ratio_error,
               to_text(method));
  }
}

BOOST_AUTO_TEST_SUITE_END()
