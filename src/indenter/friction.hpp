// Friction of an oscillating indenter: that of its cells, weighted by their mean normal force,
//   mu_macro/mu0 = int r(x) <f_n(x)> dx / int <f_n(x)> dx.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "indenter/half_space.hpp"
#include "simulation/steady/onset.hpp"
#include "simulation/system/steady_state.hpp"

namespace vcrit::indenter {

struct Friction {
  double ratio = 0;                                         ///< mu_macro/mu0
  double error = 0;                                         ///< estimate of its absolute error
  double normal_force = 0;                                  ///< mean, N
  double normal_force_error = 0;                            ///< estimate of its absolute error, N
  simulation::Regime regime = simulation::Regime::sliding;  ///< all motions of all cells
  int cells = 0;  ///< that the integrals took; 0 of a continuum, on a drive that gives
  double disagreement =
      0;  ///< largest difference of a cell's ratio, started in sliding and at rest
};

/// Of figures, and of curves to look at, where nobody sees a millionth.
inline constexpr double usual_tolerance = 1e-9, drawn_tolerance = 1e-6;

/// velocity: of the indenter, m/s, > 0; tolerance: on ratio and relative normal force, > 0, below
/// some 1e-14 of no use; on a drive that gives, of a coarse step, below 1e-9 of no use, and the
/// error is what it is. Cells are shared among the threads; the result is the same for any number
/// of them. Throws ModelError where no steady state of a cell is found, or all together take too
/// much work (effort_of_cells).
Friction friction(const HalfSpace& half_space, double velocity, double tolerance = usual_tolerance);

/// As that of one contact: of the whole, without events.
simulation::SteadyState steady_state_of(const Friction& friction);

struct IndentedPoint {
  std::optional<Friction> friction;
  std::string reason;  ///< why there is none
};

/// What presses the indenter, N: in the mean, and the least of each cell.
struct Pressed {
  double mean = 0, least = 0;
};

/// least/mean is the limit of the friction ratio as the speed vanishes, unless the body rings
/// meanwhile or the drive creeps. Throws as a HalfSpace does, and ModelError where no normal force
/// of a cell is found.
Pressed pressed(const Problem& problem);

/// One point for each velocity, in their order. What is the same at all of them is found once.
std::vector<IndentedPoint> friction_curve(const HalfSpace& half_space,
                                          std::span<const double> velocities,
                                          double tolerance = usual_tolerance);

struct CellMotion {
  double x = 0;                   ///< m
  double mean_normal_force = 0;   ///< N/m
  simulation::SteadyState state;  ///< forces in N/m
};

/// `count` cells evenly spaced from 0 on, before the edge, where nothing may be pressed; with
/// `samples` points of each cycle.
std::vector<CellMotion> cells(const HalfSpace& half_space, double velocity, int count, int samples);

/// What is asked of each cell; tests ask otherwise.
using OnsetOfCell = std::function<simulation::Onset(const simulation::System&)>;

/// The lowest velocity at which all cells slide forward whenever they are closed. That of the
/// centre where the half-space is elastic; else the highest of 64 cells, refined to about 1e-12
/// where the threshold is a smooth function of x. On a drive that gives, where all touching cells
/// slide with one velocity: that of the whole. Throws ModelError where no steady sliding is found.
simulation::Onset sliding_threshold(const HalfSpace& half_space,
                                    const OnsetOfCell& onset = simulation::sliding_threshold);

struct LastStick {
  double x = 0;  ///< of the cell that sticks longest, m
  simulation::Onset onset;
  int asked = 0, answered = 0;  ///< cells, and those of them with a steady state
};

/// The highest velocity at which a cell still sticks, from starts at rest, among 64 cells and
/// refined between them; see simulation::stick_onset. Cells without a steady state are left out and
/// counted. Throws ModelError where more than a quarter of them have none.
LastStick last_stick(const HalfSpace& half_space,
                     const OnsetOfCell& onset = simulation::stick_onset);

}  // namespace vcrit::indenter
