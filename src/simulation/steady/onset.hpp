// v* by simulation alone, in two independent ways: as the lowest speed of steady sliding, and as
// the highest speed at which a motion that starts at rest still sticks.
#pragma once

#include <string>

#include "simulation/system/system.hpp"

namespace vcrit::simulation {

/// A speed at which the kind of steady motion changes.
struct Onset {
  double contact_velocity = 0;  ///< mean velocity of the contact point there: the simulated v*, m/s
  double drive_velocity = 0;    ///< of the drive; larger only where a network on the path creeps
  std::string why_infinite = {};  ///< else empty
  /// m/s, to either side: what rounding leaves open of a last stick, does to v* of a contact that
  /// opens, and takes of a drive with masses, an estimate.
  double uncertainty = 0;
};

/// The lowest speed at which steady continuous sliding exists, from the minimum of the contact
/// velocity. Of a contact that opens: at which it slips forward whenever it is closed; infinite
/// where there is none (see forward_sliding.hpp). Throws ModelError where that is lost in rounding.
Onset sliding_threshold(const System& system);

/// The highest speed at which the steady motion still sticks, from starts at rest. Takes some 60
/// steady states; sticks that last less than about 1e-6 of a period are found, so the speed is good
/// to about 1e-12. Near resonance a body keeps its swing nearly by itself, so that cycles that are
/// nearly closed stick above it, too. Only a cycle closed to a few rounding errors tells there, and
/// between the highest speed at which one sticks and the lowest at which one slips it is left open.
/// Throws ModelError where no steady state is found.
Onset stick_onset(const System& system);

}  // namespace vcrit::simulation
