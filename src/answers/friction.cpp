#include "answers/friction.hpp"

#include "indenter/friction.hpp"
#include "rules/kinds.hpp"

namespace vcrit {

namespace {

std::variant<simulation::System, indenter::HalfSpace> motion_of(const Problem& problem,
                                                                simulation::SharedEffort* effort,
                                                                simulation::KnownModes* known) {
  if (rules::cells_move(problem)) {
    indenter::HalfSpace half_space(problem);
    return effort != nullptr ? half_space.within(*effort) : half_space;
  }
  simulation::System system = simulation::system_of(problem);
  if (effort != nullptr) system.effort = effort;
  system.known_modes = known;
  return system;
}

}  // namespace

SteadyFriction::SteadyFriction(const Problem& problem, simulation::SharedEffort* effort,
                               simulation::KnownModes* known_modes)
    : motion_(motion_of(problem, effort, known_modes)) {}

simulation::SteadyState SteadyFriction::at(double velocity, simulation::Start start) const {
  if (const auto* half_space = std::get_if<indenter::HalfSpace>(&motion_))
    return indenter::steady_state_of(indenter::friction(*half_space, velocity));
  return simulation::steady_state(std::get<simulation::System>(motion_), velocity, start);
}

void SteadyFriction::curve(
    std::span<const double> velocities,
    const std::function<void(std::size_t, const simulation::PassingPoint&)>& use,
    double tolerance) const {
  if (const auto* system = std::get_if<simulation::System>(&motion_))
    return simulation::friction_curve(*system, velocities, use);
  const auto points =
      indenter::friction_curve(std::get<indenter::HalfSpace>(motion_), velocities, tolerance);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto state = points[i].friction
                           ? std::optional(indenter::steady_state_of(*points[i].friction))
                           : std::nullopt;
    use(i, {state ? &*state : nullptr, points[i].reason.c_str()});
  }
}

}  // namespace vcrit
