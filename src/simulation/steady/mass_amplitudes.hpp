// How far the masses of a drive swing with the oscillation, beside the steady stick-slip motion.
#pragma once

#include <vector>

#include "simulation/system/system.hpp"

namespace vcrit::simulation {

struct MassAmplitude {
  Symbol symbol;
  double amplitude = 0;  ///< m, of its displacement at the frequency of the oscillation
};

/// Of a drive with masses, each that it names, the body among them: the first harmonic of the
/// friction over one period, and the drive's response to it. velocity: of the drive, m/s, > 0.
/// Empty without masses, and where the drive is in undamped resonance with the oscillation, so that
/// the two are infinite and none. Throws ModelError where no steady state is found.
std::vector<MassAmplitude> mass_amplitudes(const System& system, double velocity);

}  // namespace vcrit::simulation
