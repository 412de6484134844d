// Event-driven motion of a model: exact pieces of slip, stick, backslip and, of a contact that
// opens, of the open contact, one after the other.
#pragma once

#include <optional>

#include "modes/event_function.hpp"
#include "simulation/motion/flow.hpp"
#include "simulation/system/steady_state.hpp"

namespace vcrit::simulation {

/// The state at one instant; x as in model.hpp, its contact part that of the motion. `entered`: the
/// motion begins here, so its event function starts at zero (in stick: that of the direction from
/// which it came, +1 or -1, or `both_sides` where the contact just closed). Separated, x is that of
/// slip.
struct State {
  Motion motion = Motion::slip;
  Instant at = 0;
  Vector x;
  int entered = 0;
  Index touch = 0;  ///< of a contact that opens: the present or, separated, the next one
};

inline constexpr int both_sides = 2;  // neither of +1 and -1

/// +1 in slip, -1 in backslip, 0 without slip.
inline int direction(Motion motion) {
  return motion == Motion::slip ? 1 : (motion == Motion::backslip ? -1 : 0);
}

/// One piece of motion from a state on, in closed form. Velocities without dimension; `velocity` as
/// in model.hpp.
class Piece {
 public:
  Piece(const Model& model, double velocity, State start);

  const State& start() const { return start_; }
  bool stuck() const { return start_.motion == Motion::stick; }

  /// What the motion does over a duration, for the calls below and for changes of the start.
  Flow flow(double duration) const { return {*model_, stuck(), duration}; }
  /// The same motion, a duration later. Adds the time integrals (see model.hpp).
  State after(const Flow& flow, View integrals) const;
  State after(double duration) const;

  struct NextEvent {
    double duration = 0;
    Motion to = Motion::slip;
  };
  /// The first event within `horizon`.
  std::optional<NextEvent> next_event(double horizon) const;

  /// The function that is negative and reaches 0 where the motion changes into `to`.
  EventFunction event_function(Motion to) const;

 private:
  EventFunction slip_end() const;
  EventFunction stick_end(int side) const;
  bool leaving(Motion to) const;

  const Model* model_;
  double velocity_;
  State start_;
  Vector modes_;
};

/// How many numbers x has in a motion.
Index states(const Model& model, Motion motion);

/// Contact velocity of a state; 0 in stick.
double contact_velocity(const Model& model, double velocity, const State& state);

}  // namespace vcrit::simulation
