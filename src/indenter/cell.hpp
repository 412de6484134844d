// What one cell adds to the friction of the indenter.
#pragma once

#include <array>

#include "indenter/half_space.hpp"
#include "simulation/system/steady_state.hpp"

namespace vcrit::indenter {

/// Which motions there are besides slip.
struct Motions {
  bool separated = false, stick = false, backslip = false;

  void add(const Motions& other);
  simulation::Regime regime() const;
};

Motions motions_of(simulation::Regime regime);

struct CellFriction {
  double normal_force = 0;  ///< mean, N/m
  double ratio = 0;         ///< of friction to mu0 times it
  double error = 0;         ///< estimate of the ratio's error; the larger of two starts
  double disagreement = 0;  ///< between a start in sliding and one at rest
  Motions motions;
};

/// velocity in m/s, > 0. A cell into which the indenter dips by less than 1e-6 of its amplitude is
/// empty. Throws ModelError where no steady state is found.
CellFriction cell_friction(const HalfSpace& half_space, double x, double velocity);

/// Half the width (m) outside of which cells are empty.
double counted_edge(const HalfSpace& half_space);

/// How often each motion begins in a period; where this changes with x, friction is not smooth.
using MotionCounts = std::array<int, 4>;
MotionCounts course(const HalfSpace& half_space, double x, double velocity);

}  // namespace vcrit::indenter
