// The normal force of a contact that opens, by implicit steps: in each the network would move
// freely, unless the surface then lay below the substrate.
#pragma once

#include <vector>

#include "simulation/system/system.hpp"

namespace vcrit::simulation::methods {

/// F_n (N) at the end of each step of one steady period from t = 0 on. First order in the step.
/// Throws ModelError where the contact never closes or the force does not repeat itself.
std::vector<double> normal_force_steps(const NormalMotion& motion, double omega, int steps,
                                       Effort& effort);

}  // namespace vcrit::simulation::methods
