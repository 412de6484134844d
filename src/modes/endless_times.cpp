#include "modes/endless_times.hpp"

#include <cmath>

#include "base/constants.hpp"

namespace vcrit::simulation {

namespace {

// Modes and events take squares of rates: of times beyond 1e154 they vanish, of those below its
// inverse they overflow. This leaves a third of the exponents to what they are multiplied by.
constexpr double longest_time = 1e100, shortest_time = 1 / longest_time;

Relaxation without_times(const Relaxation& form, double longest) {
  Relaxation result{form.equilibrium, form.damper, {}};
  for (const MaxwellBranch& branch : form.branches) {
    if (branch.time > longest)
      result.equilibrium += branch.stiffness;
    else if (branch.time < shortest_time)
      result.damper += branch.stiffness * branch.time;
    else
      result.branches.push_back(branch);
  }
  return result;
}

}  // namespace

Relaxation without_endless_times(const Relaxation& form) {
  return without_times(form, longest_time);
}

Relaxation path_without_endless_times(const Relaxation& path) {
  Relaxation result = without_endless_times(path);
  if (result.damper < shortest_time) result.damper = 0;
  return result;
}

Relaxation normal_without_shortest_times(const Relaxation& normal) {
  Relaxation result = without_times(normal, infinity);
  if (result.damper < shortest_time * std::abs(dynamic_stiffness(result, 1))) result.damper = 0;
  return result;
}

}  // namespace vcrit::simulation
