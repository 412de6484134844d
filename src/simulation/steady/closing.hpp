// What is left to close a cycle after one period, and how it depends on the start.
#pragma once

#include "modes/linear_solver.hpp"
#include "simulation/motion/trace.hpp"

namespace vcrit::simulation {

/// By the numbers of the state but F.
struct Closing {
  Vector residual;
  Matrix derivative;  ///< minus that of the residual, by as many changes
  Matrix identity;    ///< in the rows of the derivative
};
Closing closing(const Model& model, const State& start, const Passage& period);

/// Of a body on a drive that creeps and takes less than its velocity in a period: closes that by
/// the impulse of all forces on it, which tells its mean velocity to as many digits as they have,
/// where its change would be lost in rounding. A few rounding errors of it; 0 of any other body,
/// which is left as it is.
double close_heavy_body(const Model& model, const Passage& period, Closing& closing);

/// For steps to where a cycle closes. Its work is counted.
LinearSolver counted_solver(const Model& model, Matrix derivative, ConstView sizes);

/// What each number of the state but F is measured by.
Vector state_size(const Model& model, double velocity, const State& start);

/// A few rounding errors of each residual over one period.
Vector rounding(const Model& model, double velocity, const State& start);

/// The same of a period that only slips. The friction on the body is given there, and how fast the
/// contact moves, however much faster than the body, leaves no rounding in it.
Vector slip_rounding(const Model& model, const State& start);

/// Throws ModelError for a body on a drive that creeps and takes less than a rounding error off its
/// velocity in a period: where that settles, nothing tells.
void check_settles(const Model& model);

/// The same also of a drive with slow branches, where every velocity of the body seems to close a
/// cycle: friction has an error that tells of it, whether a cycle sticks has none.
void check_cycles_settle(const Model& model);

/// Throws ModelError where the normal force jumps as the contact closes, by a damper of the size of
/// a rounding error: the same damper of the contact's path makes a velocity of the jump.
void check_closings(const Model& model);

/// What it says, also for v*.
[[noreturn]] void lost_at_closings();

/// The largest parts of the bound of a contact that opens: what it is a sum of.
double parts_of_bound(const Opening& opening);

/// The velocity to which forces of the drive's branches, after u in `body`, swing it.
double swing(const Model& model, ConstView body);

}  // namespace vcrit::simulation
