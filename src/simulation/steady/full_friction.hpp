// Friction between the border of free swings and v*, of a body that swings nearly freely at a
// harmonic n of the oscillation: how little of it sticks can take, proved from the motion's balance
// of power alone, whatever its sticks are like.
#pragma once

#include "simulation/motion/model.hpp"

namespace vcrit::simulation {

/// At most so much is 1 - mu_macro/mu0. velocity: as in model.hpp; 1 where nothing is known so.
double most_missing_friction(const Model& model, double velocity);

}  // namespace vcrit::simulation
