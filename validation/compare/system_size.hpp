// What a system's size allows: a report shall not take minutes.
#pragma once

#include "simulation/methods/methods.hpp"
#include "simulation/system/system.hpp"

namespace vcrit::validation {

/// So many relaxation times that methods with dense matrices take seconds for a steady state and
/// the exact one tens of milliseconds.
bool is_large(const simulation::System& system);

/// How many of the steps that a method may take with few relaxation times it may take here, from 0
/// to 1: the price of a step grows with the square of their number.
double affordable_share(const simulation::System& system);

/// What the methods beside the exact one may spend: some hundred times what they need where they do
/// well.
simulation::MethodOptions affordable(const simulation::System& system);

}  // namespace vcrit::validation
