// From v* on a sliding start slides for ever, and just below it sticks: shown by marching from
// event to event, which knows nothing of v*.
#include <cmath>
#include <numbers>

#include "property.hpp"
#include "random_systems.hpp"
#include "simulation/steady/exact.hpp"
#include "simulation/steady/steady_cycle.hpp"

BOOST_AUTO_TEST_SUITE(test_pure_sliding)

namespace {

using namespace vcrit;
using namespace vcrit::properties;
using namespace vcrit::simulation;

constexpr double period = 2 * std::numbers::pi;

struct March {
  explicit March(const Draw& draw) : model(properties::system_of(draw)) {
    RC_PRE(std::isfinite(std::abs(model.sliding_velocity)) && model.resonance < 1e3);
  }

  /// Five periods from steady sliding, with the contact's mean velocity `ratio` times v*.
  Trace march(double ratio) const {
    const double velocity = ratio * std::abs(model.sliding_velocity);
    const State start = sliding_start(model, velocity);
    return trace(model, velocity, start, 5 * period, Matrix(start.x.size(), 0));
  }

  Model model;
};

// Rounding: v* is compared with a velocity that is v* times 1 +- gap and known to some 10 u of the
// velocities that it is a difference of, creep and the body's share above all.
double gap(const Model& model, int exponent) {
  const double size = 1 + model.amplitude * (model.creep + 1) / std::abs(model.sliding_velocity);
  return std::pow(10, -exponent) + 1e-14 * size * model.resonance;
}

}  // namespace

RC_BOOST_PROP(slides_above_the_threshold, ()) {
  const auto draw = *draws(*rc::gen::element(1, 3, 6));
  const March system(draw);
  RC_PRE(system.model.sliding_velocity != 0.0);
  const Trace motion = system.march(1 + gap(system.model, *rc::gen::inRange(0, 12)));
  RC_ASSERT(motion.parts.size() == 1U);
  RC_ASSERT(motion.end.motion == Motion::slip);
  RC_ASSERT(std::abs(motion.impulse() / (5 * period)) <= 1e-15);
}

RC_BOOST_PROP(sticks_below_the_threshold, ()) {
  const auto draw = *draws(*rc::gen::element(1, 3, 6));
  const March system(draw);
  RC_PRE(system.model.sliding_velocity != 0.0);
  const double below = gap(system.model, *rc::gen::inRange(0, 12));
  RC_PRE(below < 1);
  const Trace motion = system.march(1 - below);
  RC_ASSERT(motion.parts.size() > 1U);
}

BOOST_AUTO_TEST_SUITE_END()
