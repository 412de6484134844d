#include "accuracy/simulated_cell.hpp"

#include <cmath>
#include <exception>
#include <limits>

#include "critical/admissibility.hpp"
#include "simulation/steady/exact.hpp"
#include "simulation/steady/onset.hpp"

namespace vcrit::validation::accuracy {

namespace {

// Of v*. A stick so little below it lasts for 2 sqrt(2e-6) rad, 4e-4 of a period: far longer than
// the shortest sticks that are found (simulation/steady/onset.hpp).
constexpr double beside = 1e-6;

bool slides(const simulation::System& system, double velocity) {
  return simulation::steady_state(system, velocity).regime == simulation::Regime::sliding;
}

}  // namespace

SimulatedCell simulated_cell(const Problem& problem, double right) {
  SimulatedCell cell{std::numeric_limits<double>::quiet_NaN(), {}};
  if (!std::isnormal(right)) return cell;
  // Extreme numbers may break anything; that is what is looked for.
  try {
    const simulation::System system = simulation::system_of(problem);
    cell.threshold = simulation::sliding_threshold(system).contact_velocity;
    const double creep = creep_velocity(problem);
    if (slides(system, right * (1 - beside) + creep)) cell.wrong = "misses the stick below v*";
    if (!slides(system, right * (1 + beside) + creep))
      cell.wrong += cell.wrong.empty() ? "sticks above v*" : " and sticks above it";
  } catch (const std::exception& error) {
    cell.wrong = std::string("no answer: ") + error.what();
  }
  return cell;
}

SimulatedCell not_asked(const Problem& problem) {
  SimulatedCell cell{std::numeric_limits<double>::quiet_NaN(),
                     "not asked: the stuck body swings over 10,000 times in a period"};
  try {
    const simulation::System system = simulation::system_of(problem);
    cell.threshold = simulation::sliding_threshold(system).contact_velocity;
  } catch (const std::exception& error) {
    cell.wrong = std::string("no answer: ") + error.what();
  }
  return cell;
}

}  // namespace vcrit::validation::accuracy
