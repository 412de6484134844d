// The period map's derivative, saltation included, against differences of the map itself.
#include "simulation/motion/trace.hpp"

#include <boost/test/unit_test.hpp>
#include <numbers>

#include "simulation/random_systems.hpp"
#include "simulation/steady/steady_cycle.hpp"

BOOST_AUTO_TEST_SUITE(test_trace)

namespace {

using namespace vcrit;
using namespace vcrit::simulation;

constexpr double period = 2 * std::numbers::pi;

Trace plain(const Model& model, double velocity, const State& state) {
  return trace(model, velocity, state, period);
}

double size_of(const Vector& x) {
  double largest = 0;
  for (const double value : x) largest = std::max(largest, std::abs(value));
  return largest;
}

bool same_course(const Trace& a, const Trace& b) {
  if (a.parts.size() != b.parts.size()) return false;
  for (std::size_t i = 0; i < a.parts.size(); ++i)
    if (a.parts[i].piece.start().motion != b.parts[i].piece.start().motion) return false;
  return true;
}

}  // namespace

// Central differences over 2 h: their error is h^2 times third derivatives (order 1e2 of the map
// away from grazing) and u/h; h = 1e-5 leaves 1e-8 and 1e-11 of the entries' size.
BOOST_AUTO_TEST_CASE(derivative_of_the_period_map) {
  int compared = 0;
  for (unsigned i = 0; i < 60; ++i) {
    reference::RandomSystems systems(900 + i, 1);
    const Model model(systems.system());
    const double velocity = 0.4 * std::abs(model.sliding_velocity);
    const Trace settled = plain(model, velocity, sliding_start(model, velocity));
    const State state = settled.end;
    if (state.motion != Motion::slip) continue;
    const Index n = state.x.size();
    if (n == 1) continue;
    const Trace exact = trace(model, velocity, state, period, unit_changes(state, n - 1));
    const Matrix &derivative = exact.changes.state, &integral = exact.changes.integrals;
    const double h = 1e-5;
    for (Index j = 1; j < n; ++j) {
      State up = state, down = state;
      up.x[j] += h;
      down.x[j] -= h;
      const Trace above = plain(model, velocity, up), below = plain(model, velocity, down);
      if (!same_course(above, exact) || !same_course(below, exact)) continue;
      Vector difference(n), miss(n);
      double size = 1;
      for (Index k = 0; k < n; ++k) {
        difference[k] = (above.end.x[k] - below.end.x[k]) / (2 * h);
        miss[k] = difference[k] - derivative(k, j - 1);
        size = std::max(size, std::abs(derivative(k, j - 1)));
      }
      size += 100 * size_of(difference);
      const double impulse = (above.impulse() - below.impulse()) / (2 * h);
      BOOST_TEST_CONTEXT("system " << i << ", state " << j) {
        BOOST_TEST(size_of(miss) <= 1e-7 * size);
        BOOST_TEST(std::abs(impulse - integral(0, j - 1)) <= 1e-7 * size);
        ++compared;
      }
    }
  }
  BOOST_TEST(compared > 50);
}

// Two halves of a period are the whole.
BOOST_AUTO_TEST_CASE(a_trace_may_be_cut_anywhere) {
  for (unsigned i = 0; i < 40; ++i) {
    reference::RandomSystems systems(300 + i, 3);
    const Model model(systems.system());
    const double velocity = 0.4 * std::abs(model.sliding_velocity);
    const State start = sliding_start(model, velocity);
    const Trace whole = plain(model, velocity, start);
    const Trace first = trace(model, velocity, start, 2.5);
    const Trace second = trace(model, velocity, first.end, period - 2.5);
    BOOST_TEST_REQUIRE((second.end.motion == whole.end.motion));
    // Up to 10 events, each of which passes an error of its phase on, on states of order 1 to 100.
    Vector miss = second.end.x;
    for (Index j = 0; j < miss.size(); ++j) miss[j] -= whole.end.x[j];
    BOOST_TEST(size_of(miss) <= 1e-12 * (1 + size_of(whole.end.x)));
    BOOST_TEST(std::abs(first.impulse() + second.impulse() - whole.impulse()) <= 1e-12);
  }
}

BOOST_AUTO_TEST_SUITE_END()
