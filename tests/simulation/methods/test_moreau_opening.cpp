// Implicit time stepping of contacts that open, as a witness of the exact motion: it knows neither
// its pieces nor its normal force.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "base/errors.hpp"
#include "simulation/methods/methods.hpp"
#include "simulation/steady/exact.hpp"

BOOST_AUTO_TEST_SUITE(test_moreau_opening)

namespace {

using namespace vcrit;
using namespace vcrit::simulation;

System opening(const Relaxation& contact, const Relaxation& normal) {
  System system;
  system.contact = contact;
  system.omega = 1;
  system.friction = 0.5;
  system.opening = {normal, 1, 3};
  return system;
}

System kelvin() { return opening({1, 0.3, {}}, {1, 0.3, {}}); }
System zener() { return opening({0.8, 0, {{1.6, 0.7}}}, {1, 0, {{2, 0.7}}}); }
System body() {
  System system = opening({1, 0.1, {}}, {1, 0, {{2, 0.7}}});
  system.drive = Relaxation{2, 0.1, {}};
  system.mass = 0.5;
  return system;
}

// The error depends on where events fall between steps: its envelope over eight grids, of which
// each also says how large it may be.
double envelope(const System& system, double exact, int steps) {
  double largest = 0;
  for (int i = 0; i < 8; ++i) {
    MethodOptions options;
    options.steps_per_period = steps + steps * i / 23;
    const SteadyState state = steady_state(Method::moreau, system, 0.6, options);
    const double error = std::abs(state.friction_ratio - exact);
    BOOST_TEST(error <= state.friction_ratio_error);
    BOOST_TEST((state.regime == Regime::stick_slip_separated));
    largest = std::max(largest, error);
  }
  return largest;
}

}  // namespace

// First order: half the step, half the error, over four halvings. The envelope of eight grids is
// good to a third.
BOOST_AUTO_TEST_CASE(the_exact_motion_is_its_limit) {
  for (const System& system : {kelvin(), zener(), body()}) {
    const double exact = steady_state(system, 0.6).friction_ratio;
    double before = envelope(system, exact, 1000);
    const double first = before;
    for (int steps = 2000; steps <= 16'000; steps *= 2) {
      const double now = envelope(system, exact, steps);
      BOOST_TEST(now / before > 0.5 / 1.5);
      BOOST_TEST(now / before < 0.5 * 1.5);
      before = now;
    }
    BOOST_TEST(before / first > 1.0 / 16 / 1.5);
    BOOST_TEST(before / first < 1.0 / 16 * 1.5);
  }
}

BOOST_AUTO_TEST_CASE(other_methods_refuse) {
  for (const Method method :
       {Method::rkf45, Method::rk8pd, Method::msbdf, Method::tanh, Method::reduced})
    BOOST_CHECK_EXCEPTION(steady_state(method, kelvin(), 0.6), ModelError, [](const ModelError& e) {
      return std::string(e.what()).find("opens") != std::string::npos;
    });
}

BOOST_AUTO_TEST_SUITE_END()
