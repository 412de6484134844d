#include "maps/ranks.hpp"

#include <cstdlib>

namespace vcrit::maps {

// What Open MPI, MPICH and Slurm tell the processes that they start.
int started_ranks() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"})
    if (const char* size = std::getenv(name)) return std::atoi(size);
  return 1;
}

void Ranks::first_alone(const std::function<void()>& action) const {
  together([&] {
    if (first()) action();
  });
}

}  // namespace vcrit::maps
