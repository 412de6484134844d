// Friction of any scene in steady motion: of its one contact, or of all cells below its indenter.
#pragma once

#include <functional>
#include <span>
#include <variant>

#include "indenter/friction.hpp"
#include "indenter/half_space.hpp"
#include "problem/problem.hpp"
#include "simulation/steady/curve.hpp"
#include "simulation/steady/exact.hpp"
#include "simulation/system/effort.hpp"
#include "simulation/system/system.hpp"

namespace vcrit {

class SteadyFriction {
 public:
  /// Its searches share an effort and a memory of modes that outlive it, if there are any. Throws
  /// InputError for missing values, ModelError where the scene has no motion that is known.
  explicit SteadyFriction(const Problem& problem, simulation::SharedEffort* effort = nullptr,
                          simulation::KnownModes* known_modes = nullptr);

  /// At one velocity of the drive, m/s, > 0. Below an indenter: of the whole contact, without
  /// events, compared from rest and from sliding. Throws ModelError where no steady state is found.
  simulation::SteadyState at(double velocity,
                             simulation::Start start = simulation::Start::sliding) const;

  /// use(place, point) for each velocity as it is found; nothing is thrown for one without a steady
  /// state. tolerance: below an indenter.
  void curve(std::span<const double> velocities,
             const std::function<void(std::size_t, const simulation::PassingPoint&)>& use,
             double tolerance = indenter::usual_tolerance) const;

 private:
  std::variant<simulation::System, indenter::HalfSpace> motion_;
};

}  // namespace vcrit
