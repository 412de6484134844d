#include "compare/system_size.hpp"

namespace vcrit::validation {

namespace {

// Relaxation times up to which other methods have all the work that they want, and beyond which
// they have less than a quarter of it: it goes with the square.
constexpr double few = 15, many = 30;

double relaxation_times(const simulation::System& system) {
  const std::size_t drive = system.drive ? system.drive->branches.size() : 0;
  return static_cast<double>(system.contact.branches.size() + drive);
}

}  // namespace

bool is_large(const simulation::System& system) { return relaxation_times(system) > many; }

double affordable_share(const simulation::System& system) {
  const double share = few / relaxation_times(system);
  return share < 1 ? share * share : 1;
}

simulation::MethodOptions affordable(const simulation::System& system) {
  const double share = affordable_share(system);
  simulation::MethodOptions result;
  result.most_periods = static_cast<int>(2000 * share);
  result.most_steps = static_cast<long>(300'000 * share);
  return result;
}

}  // namespace vcrit::validation
