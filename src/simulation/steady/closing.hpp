// What is left to close a cycle after one period, and how it depends on the start.
#pragma once

#include "simulation/motion/trace.hpp"

namespace vcrit::simulation {

/// By the numbers of the state but F.
struct Closing {
  Vector residual;
  Matrix derivative;  ///< minus that of the residual, by as many changes
  Matrix identity;    ///< in the rows of the derivative
};
Closing closing(const Model& model, const State& start, const Passage& period);

/// What each number of the state but F is measured by.
Vector state_size(const Model& model, double velocity, const State& start);

/// A few rounding errors of each residual over one period.
Vector rounding(const Model& model, double velocity, const State& start);

}  // namespace vcrit::simulation
