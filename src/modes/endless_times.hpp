// Branches whose times the modes of a motion cannot hold, in what they come to.
#pragma once

#include "stiffness/relaxation.hpp"

namespace vcrit::simulation {

/// The form, without dimensions and with times in radians, with springs in place of what relaxes in
/// no cycle and dampers in place of what does so at once. Their stiffness at the oscillation and
/// its harmonics differs by a share of 1e-100.
Relaxation without_endless_times(const Relaxation& form);

/// The same of the path of a force, |K(i)| = 1: without a damper that carries a share of 1e-100.
Relaxation path_without_endless_times(const Relaxation& path);

/// Whether a branch, with its time in radians, is taken as its damper.
bool relaxes_at_once(const MaxwellBranch& branch);

/// The same of a contact's normal network, in any unit of force, but with all that is slow: a
/// spring in its place would carry some of the mean load. Branches of that share are left out, too.
Relaxation normal_without_shortest_times(const Relaxation& normal);

}  // namespace vcrit::simulation
