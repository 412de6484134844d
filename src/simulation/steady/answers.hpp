// Steady states of one system at one speed after another.
#pragma once

#include <optional>

#include "simulation/steady/steady_cycle.hpp"
#include "simulation/system/steady_state.hpp"

namespace vcrit::simulation {

/// Speeds of the drive in m/s, > 0. ModelError where no steady state is found.
class Answers {
 public:
  explicit Answers(const System& system);
  Answers(const Answers&) = delete;  // cycles refer to the model
  Answers& operator=(const Answers&) = delete;

  /// Answers last until the next one, which takes their memory. Of a contact that opens the search
  /// runs from the other start, too, and the error covers both.
  const SteadyState& at(double velocity, Start start, int samples);

  /// From this start alone.
  const SteadyState& alone(double velocity, Start start, int samples);

  /// The search begins at the cycle of the speed before, where that leads to one; else anew from
  /// sliding. The other start is at rest.
  const SteadyState& next(double velocity);

  /// Mean, N.
  double normal_force() const { return model_.normal_force; }
  /// What all searches took together.
  int traced_periods() const { return traced_periods_; }

 private:
  /// More than most cycles have.
  static constexpr std::size_t usual_events = 16;

  void answer(double velocity, Start start, int samples, bool near_last);
  void answer_near_resonance(double velocity, double motion_velocity, Start start, int samples);
  bool follow(double velocity);
  void compare_starts(double velocity, Start other);

  /// The steady cycle; where none is found, the error says what makes it hard to find.
  SteadyCycle searched(double motion_velocity, Start start) const;

  Model model_;
  int nearly_free_ = 0;                   ///< harmonic, see system.hpp
  std::optional<System> near_resonance_;  ///< the system, where its motion is told from neighbours
  std::optional<SteadyCycle> last_, other_;
  SteadyState state_, other_state_;
  int traced_periods_ = 0;
};

}  // namespace vcrit::simulation
