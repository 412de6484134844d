// Friction of an indenter on a drive that gives, in steady motion, and the speed above which all
// its cells slide.
#pragma once

#include <functional>

#include "indenter/friction.hpp"
#include "indenter/half_space.hpp"

namespace vcrit::indenter {

/// By a velocity of the drive, m/s, > 0.
using FrictionOfSpeed = std::function<Friction(double velocity)>;

/// As friction() has it. What is the same at all speeds is found here, once. An elastic half-space
/// is followed without cells, as their continuum: the error is the difference to the same with a
/// thousandth of the tolerance, of a step, and what the period does not close by. Another one is
/// followed by cells in small steps of time, with half and twice as many of both: the error is
/// twice what these differ by. All throw ModelError where no steady motion is found.
FrictionOfSpeed rim_friction(const HalfSpace& half_space, double tolerance);

/// v* = mu0 max over the touching phase of d/dt [u_z/kappa + R_b * F_n], kappa = G*/E*. Infinite
/// where the body swings freely at a harmonic of the normal force, and where that has no bounded
/// rate.
simulation::Onset rim_threshold(const HalfSpace& half_space);

}  // namespace vcrit::indenter
