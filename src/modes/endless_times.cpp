#include "modes/endless_times.hpp"

#include <cmath>

#include "base/constants.hpp"

namespace vcrit::simulation {

namespace {

// Modes and events take squares of rates: of times beyond 1e154 they vanish, of those below its
// inverse they overflow. This leaves a third of the exponents to what they are multiplied by.
constexpr double longest_time = 1e100, shortest_time = 1 / longest_time;

// The share of a force below which a part of it is left out.
constexpr double least_part = 1e-100;

}  // namespace

bool relaxes_at_once(const MaxwellBranch& branch) { return branch.time < shortest_time; }

namespace {

Relaxation without_times(const Relaxation& form, double longest) {
  Relaxation result{form.equilibrium, form.damper, {}};
  for (const MaxwellBranch& branch : form.branches) {
    if (branch.time > longest)
      result.equilibrium += branch.stiffness;
    else if (relaxes_at_once(branch))
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
  if (result.damper < least_part) result.damper = 0;
  return result;
}

Relaxation normal_without_shortest_times(const Relaxation& normal) {
  Relaxation result = without_times(normal, infinity);
  const double unnoticed = least_part * std::abs(dynamic_stiffness(result, 1));
  if (result.damper < unnoticed) result.damper = 0;
  std::erase_if(result.branches,
                [&](const MaxwellBranch& branch) { return branch.stiffness < unnoticed; });
  return result;
}

}  // namespace vcrit::simulation
