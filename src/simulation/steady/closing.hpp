// What is left to close a cycle after one period, and how it depends on the start.
#pragma once

#include "simulation/motion/trace.hpp"

namespace vcrit::simulation {

/// By the numbers of the state but F.
struct Closing {
  Vector residual;
  Matrix derivative;  ///< minus that of the residual
  Matrix identity;    ///< in the rows of the derivative
};

/// A last column of changes beyond those by the state is taken as done: it goes into the residual.
Closing closing(const Model& model, const State& start, const Passage& period);

/// A few rounding errors of each residual over one period.
Vector rounding(const Model& model, double velocity, const State& start);

}  // namespace vcrit::simulation
