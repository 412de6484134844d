// The steady stick-slip cycle of a model: the fixed point of its period map, by Newton's method
// with the map's exact derivative. The energy distance between two motions never grows, so plain
// cycles are the safe way when Newton's step misses, and the friction is the same whatever the
// start.
#pragma once

#include <optional>

#include "simulation/motion/trace.hpp"

namespace vcrit::simulation {

struct SteadyCycle {
  Trace period;      ///< one period from a state in slip on, or separated where the contact opens
  double ratio = 0;  ///< <F>/(mu0 <F_n>)
  double error = 0;  ///< estimate of its absolute error
  int traced = 0;    ///< periods that the search took
};

/// velocity: as in model.hpp, below the sliding threshold and above stick.
/// Throws ModelError if no closed cycle is found.
SteadyCycle steady_cycle(const Model& model, double velocity, State start);

/// The same, closed to a few rounding errors, so that what sticks and what slips in it does.
/// Nothing where no such cycle is found.
std::optional<SteadyCycle> strictly_steady_cycle(const Model& model, double velocity, State start);

/// The same, beginning at the steady cycle of another velocity; nothing where that does not lead to
/// one at once.
std::optional<SteadyCycle> steady_cycle_near(const Model& model, double velocity,
                                             const SteadyCycle& other);

/// Of a contact that opens: in the middle of the longest separation, nothing deformed, the body
/// with the drive or at rest.
State separated_start(const Model& model, double velocity, bool at_rest);

/// Forward sliding as near to steady sliding as the drive allows, at its fastest moment (whether
/// the contact ever slows to 0 or not), and a body at rest on an undeformed contact.
State sliding_start(const Model& model, double velocity);
State rest_start(const Model& model, double velocity);

}  // namespace vcrit::simulation
