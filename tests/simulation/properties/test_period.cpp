// The steady motion has the oscillation's own period: a start at rest, marched from event to event
// and compared with itself one to four periods later. No fixed point is looked for.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "property.hpp"
#include "random_systems.hpp"
#include "simulation/steady/exact.hpp"
#include "simulation/steady/onset.hpp"
#include "simulation/steady/steady_cycle.hpp"

BOOST_AUTO_TEST_SUITE(test_period)

namespace {

using namespace vcrit;
using namespace vcrit::properties;
using namespace vcrit::simulation;

constexpr double period = 2 * std::numbers::pi;

// A damper beside the drive, so that transients die in hundreds of periods.
System damped(const Draw& draw) {
  System system = properties::system_of(draw);
  if (system.drive) system.drive->damper += 0.3;
  return system;
}

class March {
 public:
  March(const Model& model, double velocity) : model_(model), velocity_(velocity) {}

  /// At rest until something slips, and a radian more, so that no event is at the beginning.
  State start() const {
    const State first = next_event_state(model_, velocity_, rest_start(model_, velocity_), 1e12);
    return over(first, 1).end;
  }
  Trace over(const State& state, double duration) const {
    return trace(model_, velocity_, state, duration, Matrix(state.x.size(), 0));
  }
  Trace next(const State& state) const { return over(state, period); }

 private:
  const Model& model_;
  double velocity_;
};

// Relative; 1 where the kinds of motion differ.
double difference(const State& a, const State& b) {
  if (a.motion != b.motion) return 1;
  double size = 1, largest = 0;
  for (Index i = 0; i < a.x.size(); ++i) {
    size = std::max(size, std::abs(a.x[i]));
    largest = std::max(largest, std::abs(a.x[i] - b.x[i]));
  }
  return largest / size;
}

bool same_pieces(const Trace& a, const Trace& b, double tolerance) {
  if (a.parts.size() != b.parts.size()) return false;
  for (std::size_t i = 0; i < a.parts.size(); ++i)
    if (a.parts[i].piece.start().motion != b.parts[i].piece.start().motion ||
        std::abs(a.parts[i].duration - b.parts[i].duration) > tolerance)
      return false;
  return true;
}

}  // namespace

// A motion that returned to itself after two or more periods only would never settle here. What is
// left of a transient when twenty periods change the state by 1e-11 each may be 1e3 times that, as
// some decay by a thousandth a period; events move by that over the velocities' rates, of the order
// of the amplitude.
RC_BOOST_PROP(one_period_is_the_oscillations, ()) {
  const auto draw = *draws(1);
  const int sixteenths = *rc::gen::inRange(1, 21);
  const System system = damped(draw);
  const double velocity =
      sliding_threshold(system).drive_velocity * std::pow(10, -sixteenths / 16.0);
  const Model model(system);
  const double speed = model.motion_velocity(velocity / model.velocity_unit);
  RC_PRE(!model.never_slips(speed));
  const March march(model, speed);

  State state = march.start();
  int quiet = 0;
  for (int n = 0; n < 10000 && quiet < 20; ++n) {
    State next = march.next(state).end;
    quiet = difference(state, next) <= 1e-11 ? quiet + 1 : 0;
    state = std::move(next);
  }
  RC_ASSERT(quiet == 20);

  const Trace first = march.next(state);
  State later = first.end;
  for (int n = 0; n < 4; ++n) {
    const Trace again = march.next(later);
    RC_ASSERT(difference(state, later) <= 1e-10);
    RC_ASSERT(same_pieces(first, again, 1e-8 / draw.amplitude));
    later = again.end;
  }
  const double ratio = 1 + first.impulse() / period;
  RC_ASSERT(std::abs(ratio - steady_state(system, velocity).friction_ratio) <= 1e-8);
}

BOOST_AUTO_TEST_SUITE_END()
