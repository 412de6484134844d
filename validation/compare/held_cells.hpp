// An indenter on a drive that gives, as so many plain cells in small steps of time: what
// its v* and friction are compared with. It shares the scene's numbers with what it checks
// (src/indenter/rim_friction.hpp), and no line of its motion: no continuum, no events, no
// collocation, and no cycle of the normal force: cells are pressed step by step, too.
#pragma once

#include <vector>

#include "indenter/half_space.hpp"

namespace vcrit::validation {

struct HeldMarch {
  double ratio = 0;     ///< mean friction over mu0 times the mean normal force, of the last period
  bool sticks = false;  ///< whether a cell that touches sticks at some step of it
};

/// F_n, N, at the end of each step of a period from phase 0 on, in the steady state; the first is
/// at phase 0. Throws ModelError where what cells remember takes too many periods to fade.
std::vector<double> pressed_in_steps(const indenter::HalfSpace& half_space, int cells, int steps);

/// At a velocity of the drive, m/s, > 0, with so many cells of equal width and steps a period, on
/// a drive that carries a static load. Both errors are of second order
/// but where cells touch: a cell touches late or early by half its width. Throws ModelError where
/// no motion is found that repeats.
HeldMarch march_held_cells(const indenter::HalfSpace& half_space, double velocity, int cells,
                           int steps);

}  // namespace vcrit::validation
