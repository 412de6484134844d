// Event-driven motion of a model: exact pieces of slip, stick and backslip, one after the other.
#pragma once

#include <optional>
#include <vector>

#include "simulation/motion/model.hpp"
#include "simulation/system/steady_state.hpp"

namespace vcrit::simulation {

/// The state at one instant; x as in model.hpp, its contact part that of the motion. `entered`: the
/// motion begins here, so its event function starts at zero (in stick: that of the direction from
/// which it came, +1 or -1).
struct State {
  Motion motion = Motion::slip;
  double time = 0;
  Vector x;
  int entered = 0;
};

/// +1 in slip, -1 in backslip, 0 in stick.
int direction(Motion motion);

/// One piece of motion from a state on, in closed form. Velocities without dimension; `velocity` is
/// that of the drive.
class Piece {
 public:
  Piece(const Model& model, double velocity, State start);

  const State& start() const { return start_; }
  /// The same motion, `duration` later.
  State after(double duration) const;
  /// Time integrals of the levels F, u, g_j over the first `duration`.
  Vector integrals(double duration) const;
  double contact_velocity(double duration) const;
  double force(double duration) const;

  struct Event {
    double duration = 0;
    Motion to = Motion::slip;
  };
  /// The first event within `horizon`.
  std::optional<Event> next_event(double horizon) const;

  /// Changes dx of the start, at fixed time and column by column, carried on by `duration`; adds
  /// the changes of the levels' integrals to `integrals`.
  Matrix carried(const Matrix& dx, double duration, Matrix& integrals) const;

 private:
  bool stuck() const { return start_.motion == Motion::stick; }
  const Phase& phase() const { return stuck() ? model_->stick : model_->slip; }
  Matrix moved(const Matrix& x, const Matrix& modes, double duration) const;
  std::optional<Event> slip_end(double horizon) const;
  std::optional<double> stick_end(int side, double horizon) const;

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
