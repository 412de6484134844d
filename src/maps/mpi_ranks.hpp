// All processes that mpirun started for one sweep.
#pragma once

#include <memory>

#include "maps/ranks.hpp"

namespace vcrit::maps {

/// This process alone where mpirun has not started several. Throws InputError if it has and this
/// program knows no MPI.
std::unique_ptr<Ranks> all_ranks();

}  // namespace vcrit::maps
