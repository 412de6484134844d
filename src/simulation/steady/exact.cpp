#include "simulation/steady/exact.hpp"

#include "simulation/steady/answers.hpp"

namespace vcrit::simulation {

SteadyState steady_state(const System& system, double velocity, Start start, int samples) {
  return Answers(system).at(velocity, start, samples);
}

}  // namespace vcrit::simulation
