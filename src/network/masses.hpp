// Masses inside a drive network. Only oscillations count: in them the far end of the drive (the
// network's second end), which moves uniformly, stands still like the inertial ground that every
// mass pushes against. A mass is therefore an element between a point of the network and the far
// end, with K = m s^2.
#pragma once

#include <optional>
#include <vector>

#include "network/network.hpp"

namespace vcrit {

bool has_masses(const Network& network);

/// Of springs and dampers alone, without lossy springs and tables: it relaxes, by spectra and in
/// time.
bool of_springs_and_dampers(const Network& network);

/// The masses with no end at the network's second end, in the order of writing.
std::vector<Symbol> masses_off_the_far_end(const Network& network);

/// Only masses, no springs or dampers, lead from one end to the other.
bool hangs_on_masses(const Network& network);

/// What carries a load at rest: the network without its masses. Nothing if it hangs on masses.
std::optional<Network> without_masses(const Network& network);

}  // namespace vcrit
