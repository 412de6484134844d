#include "modes/endless_times.hpp"

namespace vcrit::simulation {

namespace {

// Modes and events take squares of rates: of times beyond 1e154 they vanish, of those below its
// inverse they overflow. This leaves a third of the exponents to what they are multiplied by.
constexpr double longest_time = 1e100, shortest_time = 1 / longest_time;

}  // namespace

Relaxation without_endless_times(const Relaxation& form) {
  Relaxation result{form.equilibrium, form.damper, {}};
  for (const MaxwellBranch& branch : form.branches) {
    if (branch.time > longest_time)
      result.equilibrium += branch.stiffness;
    else if (branch.time < shortest_time)
      result.damper += branch.stiffness * branch.time;
    else
      result.branches.push_back(branch);
  }
  return result;
}

Relaxation path_without_endless_times(const Relaxation& path) {
  Relaxation result = without_endless_times(path);
  if (result.damper < shortest_time) result.damper = 0;
  return result;
}

}  // namespace vcrit::simulation
