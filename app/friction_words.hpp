// What a simulation found, in words: the speed, friction as a ratio, a force and a coefficient, the
// motion.
#pragma once

#include <string>

#include "base/rounded.hpp"
#include "problem/problem.hpp"
#include "simulation/system/steady_state.hpp"
#include "speed_options.hpp"

namespace vcrit::app {

struct FrictionFound {
  double ratio = 0, error = 0;   ///< mu/mu0
  double mean_normal_force = 0;  ///< N
  simulation::Regime regime = simulation::Regime::sliding;
};

/// Title and operating point of the scene, what vibration does at this speed, and the rows of
/// numbers, as print_row() has them.
void print_friction(const Problem& problem, const Speed& speed, const FrictionFound& found,
                    int digits);

/// "0.8782 of the sliding value (error about 2e-16)": no more digits than the error leaves.
std::string friction_ratio_words(double ratio, double error, int digits);

/// "stick-slip: the contact sticks for a part of every cycle"; below an indenter it is the rim that
/// opens.
std::string regime_words(simulation::Regime regime, bool below_indenter = false);

}  // namespace vcrit::app
