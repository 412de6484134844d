// The steady normal force in N and seconds, which does not depend on what the contact does along
// the surface.
#pragma once

#include "normal/normal_cycle.hpp"
#include "normal/normal_motion.hpp"

namespace vcrit::simulation {

/// A time less whole periods, in [0, 2 pi).
double wrapped(double t);

/// Whether a part of the network answers within 1e-100 radians: its modes leave that out.
bool answers_at_once(const NormalMotion& motion, double omega);

/// Its modes, with omega t for time.
ContactModes modes_of(const NormalMotion& motion, double omega);

/// The cycle of the normal force, in N, with omega t for time.
NormalCycle steady_normal_force(const NormalMotion& motion, double omega);

/// Whether the contact is closed at omega t = phase in [0, 2 pi). Throws ModelError where the cycle
/// is not found.
bool touches_at(const NormalMotion& motion, double omega, double phase);

}  // namespace vcrit::simulation
