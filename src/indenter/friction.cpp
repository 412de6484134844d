#include "indenter/friction.hpp"

#include <fmt/core.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <mutex>

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "indenter/changes.hpp"
#include "indenter/panels.hpp"
#include "indenter/rim_friction.hpp"
#include "normal/pressed_cells.hpp"
#include "simulation/steady/answers.hpp"
#include "simulation/steady/exact.hpp"
#include "simulation/steady/normal_force.hpp"

namespace vcrit::indenter {

namespace {

constexpr std::size_t scanned = 64;

// Of the cells that are asked for their last stick.
constexpr double least_answered = 0.75;

// Under a flat punch on a drive that gives.
Friction of_whole(const HalfSpace& half_space, double velocity) {
  simulation::Answers answers(half_space.whole());
  const simulation::SteadyState& state = answers.alone(velocity, simulation::Start::sliding, 0);
  Friction result;
  result.ratio = state.friction_ratio;
  result.regime = state.regime;
  result.cells = 1;
  result.error = state.friction_ratio_error;
  result.normal_force = answers.normal_force();
  result.normal_force_error = 16 * epsilon * result.normal_force;
  const simulation::SteadyState& other = answers.alone(velocity, simulation::Start::rest, 0);
  result.disagreement = std::abs(other.friction_ratio - result.ratio);
  result.error = std::max(result.error, other.friction_ratio_error);
  return result;
}

Friction of_one_cell(const HalfSpace& half_space, double velocity) {
  const CellFriction cell = cell_friction(half_space, 0, velocity);
  const double force = 2 * half_space.edge() * cell.normal_force;
  return {cell.ratio, cell.error,       force, 16 * epsilon * force, cell.motions.regime(),
          1,          cell.disagreement};
}

// N: of u_z0 - g(x) + du_z in rounding, as the normal force feels it.
double depth_error(const HalfSpace& half_space) {
  const double depth = half_space.indentation() + half_space.amplitude();
  return 4 * epsilon * half_space.static_modulus() * depth * half_space.edge();
}

// N: the normal force of cells that touch for too short a time, which decreases outwards.
double left_out(const HalfSpace& half_space) {
  const double edge = counted_edge(half_space);
  if (!half_space.touches(edge)) return 0;
  return (half_space.edge() - edge) *
         std::abs(simulation::mean_normal_force(half_space.cell(edge)));
}

// Collects the results of all cells, within a limit of total work.
template <class Find>
auto within_effort(const HalfSpace& given, const Find& find) {
  simulation::SharedEffort effort(simulation::effort_of_cells, given.effort());
  const auto result = find(given.within(effort));
  effort.require_enough();
  return result;
}

Friction of_all_cells(const HalfSpace& half_space, double velocity, double tolerance) {
  const PanelIntegrals sum =
      integrals(half_space, velocity, changes(half_space, velocity), tolerance);
  const double outside =
      left_out(half_space) + depth_error(half_space) + 16 * epsilon * sum.normal_force;
  Friction result;
  result.ratio = sum.friction / sum.normal_force;
  result.error = sum.ratio_error + (sum.cell_error + outside) / sum.normal_force;
  result.normal_force = 2 * sum.normal_force;
  result.normal_force_error = 2 * (sum.normal_force_error + outside);
  result.regime = sum.motions.regime();
  result.cells = sum.cells;
  result.disagreement = sum.disagreement;
  return result;
}

// The cell of the highest onset, which is one of drive velocity 0 for a cell without an answer.
LastStick highest(const HalfSpace& half_space, const OnsetOfCell& onset) {
  const auto at = [&](double x) { return onset(half_space.cell(x)); };
  const double step = half_space.edge() / static_cast<double>(scanned);
  std::vector<LastStick> all(scanned);
  tbb::parallel_for(std::size_t{0}, scanned, [&](std::size_t i) {
    const double x = step * static_cast<double>(i);
    all[i] = {x, at(x)};
  });
  const auto lower = [](const LastStick& a, const LastStick& b) {
    return a.onset.drive_velocity < b.onset.drive_velocity;
  };
  const auto best = std::max_element(all.begin(), all.end(), lower);
  const auto i = static_cast<double>(best - all.begin());
  const double x = boost::math::tools::brent_find_minima(
                       [&](double place) { return -at(place).drive_velocity; },
                       step * std::max(i - 1, 0.0), step * std::min(i + 1, scanned - 1.0), 26)
                       .first;
  LastStick result = std::max(*best, LastStick{x, at(x)}, lower);
  result.asked = static_cast<int>(scanned);
  result.answered = static_cast<int>(std::count_if(
      all.begin(), all.end(), [](const LastStick& cell) { return cell.onset.drive_velocity > 0; }));
  return result;
}

FrictionOfSpeed friction_of(const HalfSpace& given, double tolerance) {
  if (!(tolerance > 0))
    throw InputError(argument("tolerance"), fmt::format("{}", tolerance),
                     "a relative error above 0");
  if (given.holder() && !given.uniform()) return rim_friction(given, tolerance);
  return [&given, tolerance](double velocity) {
    if (given.holder()) return of_whole(given, velocity);
    if (given.uniform()) return of_one_cell(given, velocity);
    return within_effort(given, [&](const HalfSpace& half_space) {
      return of_all_cells(half_space, velocity, tolerance);
    });
  };
}

}  // namespace

Friction friction(const HalfSpace& half_space, double velocity, double tolerance) {
  simulation::require_forward(velocity);
  return friction_of(half_space, tolerance)(velocity);
}

// Whatever the drive: where the speed vanishes each cell sticks but for the instant at which it
// carries least, and the body stands still.
Pressed pressed(const Problem& problem) {
  const double least = HalfSpace(problem).least_force();
  return {problem->load ? problem.value(*problem->load) : simulation::mean_force_of_cells(problem),
          least};
}

simulation::SteadyState steady_state_of(const Friction& friction) {
  simulation::SteadyState state;
  state.friction_ratio = friction.ratio;
  state.friction_ratio_error = friction.error;
  state.regime = friction.regime;
  return state;
}

std::vector<IndentedPoint> friction_curve(const HalfSpace& half_space,
                                          std::span<const double> velocities, double tolerance) {
  std::vector<IndentedPoint> curve(velocities.size());
  FrictionOfSpeed friction_at;
  try {
    friction_at = friction_of(half_space, tolerance);
  } catch (const ModelError& error) {
    for (IndentedPoint& point : curve) point.reason = error.what();
    return curve;
  }
  tbb::parallel_for(std::size_t{0}, curve.size(), [&](std::size_t i) {
    try {
      simulation::require_forward(velocities[i]);
      curve[i].friction = friction_at(velocities[i]);
    } catch (const ModelError& error) {
      curve[i].reason = error.what();
    }
  });
  return curve;
}

std::vector<CellMotion> cells(const HalfSpace& half_space, double velocity, int count,
                              int samples) {
  simulation::require_forward(velocity);
  if (count <= 0 || samples < 0)
    throw InputError({"cells"}, fmt::format("{} cells with {} samples", count, samples),
                     "one cell or more, and no samples or some");
  std::vector<CellMotion> result(static_cast<std::size_t>(count));
  tbb::parallel_for(std::size_t{0}, result.size(), [&](std::size_t i) {
    const double x = half_space.edge() * static_cast<double>(i) / count;
    const simulation::System system = half_space.cell(x);
    result[i] = {x, simulation::mean_normal_force(system),
                 simulation::steady_state(system, velocity, simulation::Start::sliding, samples)};
  });
  return result;
}

simulation::Onset sliding_threshold(const HalfSpace& given, const OnsetOfCell& onset) {
  if (given.holder()) return given.uniform() ? onset(given.whole()) : rim_threshold(given);
  return within_effort(given, [&](const HalfSpace& half_space) {
    const bool centre = half_space.elastic() || half_space.uniform();
    return centre ? onset(half_space.cell(0)) : highest(half_space, onset).onset;
  });
}

// The highest onset may be that of a cell without an answer: with so many of them nothing is said.
LastStick last_stick(const HalfSpace& given, const OnsetOfCell& onset) {
  std::mutex lock;
  std::string why;
  const auto if_any = [&](const simulation::System& cell) {
    try {
      return onset(cell);
    } catch (const ModelError& error) {
      const std::lock_guard hold(lock);
      if (why.empty() || error.what() < why) why = error.what();  // whichever thread was first
      return simulation::Onset{};
    }
  };
  const LastStick found = within_effort(
      given, [&](const HalfSpace& half_space) { return highest(half_space, if_any); });
  if (found.answered >= least_answered * found.asked) return found;
  throw ModelError(
      fmt::format("the last stick below the indenter is not known: of {} cells {} "
                  "have a steady state; of one of the others {}",
                  found.asked, found.answered, why));
}

}  // namespace vcrit::indenter
