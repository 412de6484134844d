// The paper's reduced model against digits computed independently of it, its elastic limit against
// the closed form, its own error estimate against the full motion, and what it refuses.
#include "simulation/methods/methods.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "base/errors.hpp"
#include "simulation/reference_systems.hpp"

BOOST_AUTO_TEST_SUITE(test_reduced)

namespace {

using namespace vcrit;
using namespace vcrit::simulation;

constexpr double u = 1.1e-16;

// k = 1, omega = 1, mu0 <F_n> = 1, F_n oscillates by `amplitude` of its mean.
System kelvin(double delta, double amplitude) {
  System system;
  system.contact = {1, delta, {}};
  system.omega = 1;
  system.friction = 0.5;
  system.mean_normal_force = 2;
  system.normal_force_amplitude = {0, 2 * amplitude};
  return system;
}

// v* of an isotropic Kelvin contact: omega du_z k_n/k_t, and the amplitude is du_z sqrt(1 +
// delta^2).
double critical(double delta, double amplitude) { return amplitude / std::hypot(1, delta); }

SteadyState reduced(const System& system, double velocity) {
  return steady_state(Method::reduced, system, velocity);
}

std::string refusal(const System& system) {
  try {
    reduced(system, 0.1);
  } catch (const ModelError& error) {
    return error.what();
  }
  return "";
}

struct Value {
  double delta, ratio, reduced, full;
};

// Solved with 30 digits elsewhere; amplitude 0.9. `full` keeps the transient.
constexpr Value values[] = {
    {0, 0.1, 0.31854577586218, 0.31854577586218},  {0, 0.5, 0.81869301699970, 0.81869301699970},
    {1, 0.1, 0.4642607132736, 0.39759612266688},   {1, 0.5, 0.8367398045185, 0.83273654706667},
    {10, 0.1, 0.7207052919138, 0.43472823801559},  {10, 0.5, 0.8917875223416, 0.84557858278721},
    {100, 0.1, 0.7535068053240, 0.43532479146987}, {100, 0.5, 0.9008758004292, 0.84580444804486}};

}  // namespace

// The values are given to 13 or 14 decimals.
BOOST_AUTO_TEST_CASE(independent_values) {
  for (const Value& value : values) {
    const SteadyState state =
        reduced(kelvin(value.delta, 0.9), value.ratio * critical(value.delta, 0.9));
    BOOST_TEST(std::abs(state.friction_ratio - value.reduced) <= 1e-13);
    BOOST_TEST(std::abs(state.friction_ratio - value.full) <= state.friction_ratio_error + 1e-14);
    BOOST_TEST(state.events.size() == 2U);
    BOOST_TEST(state.periods.value_or(0) == 1);
  }
}

// mu_macro/mu0 = 1 - D G(v), G to 20 digits; a handful of operations on numbers of order 1, phases
// up to 2 pi.
BOOST_AUTO_TEST_CASE(elastic_closed_form) {
  const double closed[][2] = {{0.001, 0.99693266303416232517},   {0.1, 0.75717136015312994339},
                              {0.25, 0.4918816026829403061},     {0.5, 0.2014522033336686888},
                              {0.75, 0.047238266278833194827},   {0.9, 0.0073108103345282100357},
                              {0.99, 0.000071763498506863749421}};
  for (const double d : {0.1, 0.9, 0.999})
    for (const auto& [ratio, g] : closed) {
      const SteadyState state = reduced(kelvin(0, d), ratio * d);
      BOOST_TEST(std::abs(state.friction_ratio - (1 - d * g)) <= 20 * u);
      BOOST_TEST(state.friction_ratio_error <= 10 * u);
    }
}

// Stick begins where steady sliding would turn back, (50), and that is where the friction bound
// falls fastest for an elastic contact as v -> v*: a quarter period after F_n's maximum, plus pi.
BOOST_AUTO_TEST_CASE(events_stand_at_their_phase) {
  const SteadyState state = reduced(kelvin(0, 0.9), 0.9 * (1 - 1e-10));
  for (const Event& event : state.events) {
    // F_n = mean + Re[i a e^{i phase}]: its maximum is at phase 3 pi/2, so 3 pi/2 + 3 pi/2 = pi.
    BOOST_TEST(std::abs(event.phase - std::acos(-1.0)) < 1e-4);
  }
  // At half of v*: tau1 = pi + asin(1/2).
  const SteadyState half = reduced(kelvin(0, 0.9), 0.45);
  const double begin = std::acos(-1.0) * (1 + 1.0 / 6 + 1.5 - 2);
  const bool stick_first = half.events[0].to == Motion::stick;
  BOOST_TEST(std::abs(half.events[stick_first ? 0 : 1].phase - begin) < 1e-14);
}

BOOST_AUTO_TEST_CASE(slides_from_the_critical_velocity_on) {
  for (const double delta : {0.0, 1.0, 100.0}) {
    const double v = critical(delta, 0.9);
    BOOST_TEST(reduced(kelvin(delta, 0.9), 1.000001 * v).friction_ratio == 1.0);
    BOOST_TEST((reduced(kelvin(delta, 0.9), 1.000001 * v).regime == Regime::sliding));
    BOOST_TEST((reduced(kelvin(delta, 0.9), 0.999999 * v).regime == Regime::stick_slip));
  }
}

BOOST_AUTO_TEST_CASE(refused_systems_are_named) {
  System system = kelvin(1, 0.5);
  system.drive = Relaxation{1, 0, {}};
  BOOST_TEST(refusal(system).find("a drive that is not rigid") != std::string::npos);
  BOOST_TEST(refusal(system).find("a mass") == std::string::npos);
  system.mass = 1;
  BOOST_TEST(refusal(system).find("a mass") != std::string::npos);
  system = kelvin(1, 0.5);
  system.contact.branches = {{1, 1}};
  BOOST_TEST(refusal(system).find("Maxwell branches") != std::string::npos);
  system.contact = {0, 1, {}};
  BOOST_TEST(refusal(system).find("without a spring") != std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
