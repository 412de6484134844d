#include "simulation/steady/exact.hpp"

#include <fmt/core.h>

#include "base/errors.hpp"
#include "simulation/steady/answers.hpp"

namespace vcrit::simulation {

SteadyState steady_state(const System& system, double velocity, Start start, int samples) {
  if (samples < 0)
    throw InputError(argument("samples"), fmt::format("{} points of the cycle", samples),
                     "0 or more");
  return Answers(system).at(velocity, start, samples);
}

}  // namespace vcrit::simulation
