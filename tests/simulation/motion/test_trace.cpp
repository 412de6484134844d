// The period map's derivative, saltation included, against differences of the map itself.
#include "simulation/motion/trace.hpp"

#include <boost/test/unit_test.hpp>
#include <numbers>
#include <optional>

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

/// Of the end of a period, and of the impulse in it at last.
struct Differences {
  std::vector<double> value, error;
};

/// None where a neighbour takes another course.
std::optional<std::vector<double>> difference(const Model& model, double velocity,
                                              const Trace& course, State state, Index j, double h) {
  const double x = state.x[j];
  state.x[j] = x + h;
  const Trace above = plain(model, velocity, state);
  state.x[j] = x - h;
  const Trace below = plain(model, velocity, state);
  if (!same_course(above, course) || !same_course(below, course)) return std::nullopt;
  std::vector<double> result;
  for (Index k = 0; k < state.x.size(); ++k)
    result.push_back((above.end.x[k] - below.end.x[k]) / (2 * h));
  result.push_back((above.impulse() - below.impulse()) / (2 * h));
  return result;
}

/// Where the map is smooth, central differences over 2 h err by c h^2 + O(h^4), so that those over
/// h and 2 h give one that errs by O(h^4). Another one, over 2 h and 4 h, differs from it by 15
/// times that; a third of the difference leaves a factor of 5 for higher orders.
std::optional<Differences> differences(const Model& model, double velocity, const Trace& course,
                                       const State& state, Index j) {
  constexpr double h = 1e-4;
  const auto one = difference(model, velocity, course, state, j, h),
             two = difference(model, velocity, course, state, j, 2 * h),
             four = difference(model, velocity, course, state, j, 4 * h);
  if (!one || !two || !four) return std::nullopt;
  Differences result;
  for (std::size_t k = 0; k < one->size(); ++k) {
    const double fine = (4 * one->at(k) - two->at(k)) / 3,
                 coarse = (4 * two->at(k) - four->at(k)) / 3;
    result.value.push_back(fine);
    result.error.push_back(std::abs(fine - coarse) / 3);
  }
  return result;
}

}  // namespace

// Up to 10 events of ten roundings each, 1e-14 of the end of a trace, are divided by h = 1e-4.
BOOST_AUTO_TEST_CASE(derivative_of_the_period_map) {
  int compared = 0;
  for (unsigned i = 0; i < 60; ++i) {
    reference::RandomSystems systems(900 + i, 1);
    const Model model(systems.system());
    const double velocity = 0.4 * std::abs(model.sliding_velocity);
    const State state = plain(model, velocity, sliding_start(model, velocity)).end;
    if (state.motion != Motion::slip) continue;
    const Index n = state.x.size();
    if (n == 1) continue;
    const Trace exact = trace(model, velocity, state, period, unit_changes(state, n - 1));
    const Matrix &derivative = exact.changes.state, &integral = exact.changes.integrals;
    for (Index j = 1; j < n; ++j) {
      const auto steps = differences(model, velocity, exact, state, j);
      if (!steps) continue;
      BOOST_TEST_CONTEXT("system " << i << ", state " << j) {
        const double rounding = 1e-10 * (1 + size_of(exact.end.x));
        for (Index k = 0; k < n; ++k)
          BOOST_TEST(std::abs(steps->value[k] - derivative(k, j - 1)) <=
                     steps->error[k] + rounding);
        BOOST_TEST(std::abs(steps->value.back() - integral(0, j - 1)) <=
                   steps->error.back() + rounding);
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
