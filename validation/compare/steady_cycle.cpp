#include "compare/steady_cycle.hpp"

#include "simulation/steady/exact.hpp"

namespace vcrit::validation {

namespace {

constexpr int cycle_samples = 240;  // 1.5 degrees each

}  // namespace

Cycle steady_cycle(const simulation::System& system, double velocity) {
  const auto steady =
      simulation::steady_state(system, velocity, simulation::Start::sliding, cycle_samples);
  return {1, velocity, steady.friction_ratio, to_text(steady.regime), steady.cycle, steady.events};
}

}  // namespace vcrit::validation
